/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_flat_faces.h"

#include "domain.h"
#include "fix_tmsph_bond.h"
#include "tmsph_kernel.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;

// a flat face ends at other ones: in so many steps of a horizon along it no curved rim, whose steps
// have short flat stretches too; with 3 the errors of the coarsest discs of test_heat_disc change
// by 4 %, with 1 their order is lost

static constexpr int STEPS_ALONG = 6;

/* ---------------------------------------------------------------------- */

TMSPHFlatFaces::TMSPHFlatFaces(LAMMPS *lmp, TMSPHGhostSender &sender) :
    Pointers(lmp), ghosts(sender)
{
}

/* ---------------------------------------------------------------------- */

void TMSPHFlatFaces::init(const FixTMSPHBond *owner, const TMSPHBondUser *style)
{
  bonds = owner;
  user = style;
}

/* ---------------------------------------------------------------------- */

void TMSPHFlatFaces::find(const std::vector<char> &near, std::vector<double> &second)
{
  if (domain->dimension == 2)
    find_layers<2>(near, second);
  else
    find_layers<3>(near, second);
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHFlatFaces::find_layers(const std::vector<char> &near, std::vector<double> &second)
{
  std::vector<double> rough(atom->nlocal, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!near[i]) continue;
    const double horizon = user->horizon(atom->type[i], atom->type[i]), V = atom->vfrac[i];
    const auto weight = [&](double R) {
      return V * V * kernel_slope(user->kernel_of_bonds(), D, R, horizon);
    };
    LatticeFaces<D> family(horizon);
    for (const auto &bond : bonds->family(i, FixTMSPHBond::FORMED)) {
      double X[3];
      bonds->reference_vector(i, bond.j, X);
      family.add(X);
    }
    rough[i] = !family.find(weight);
    if (family.found().empty()) continue;
    double *to = make_row(i);
    for (const Layer<D> &layer : family.found()) {
      layer.put(to);
      to += Layer<D>::SIZE;
    }
    second[i] = family.second_moment(weight) / V;
  }
  complete();
  for (int step = 0; step < STEPS_ALONG && faced; step++) drop_steps<D>(rough);
  complete();
}

/* ----------------------------------------------------------------------
   forgets the faces along which a partner is that does not know what bounds it
   @param rough such particles; more of them after this
------------------------------------------------------------------------- */

template <int D> void TMSPHFlatFaces::drop_steps(std::vector<double> &rough)
{
  ghosts.complete(rough);
  std::vector<double> more(rough.begin(), rough.begin() + atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) {
    const int faces = count(i);
    for (int k = 0; k < faces; k++) {
      const Layer<D> own = layer<D>(i, k);
      for (const auto &bond : bonds->family(i, FixTMSPHBond::FORMED)) {
        if (more[i]) break;
        if (!rough[bond.j]) continue;
        double X[3];
        bonds->reference_vector(i, bond.j, X);
        more[i] = own.along(X);
      }
    }
    if (more[i]) face_row[i] = NONE;
  }
  rough = more;
}

/* ---------------------------------------------------------------------- */

double TMSPHFlatFaces::factor(int i, int j, const double *X) const
{
  if (!beside(i, j)) return 1.0;
  return domain->dimension == 2 ? 0.5 * (boost<2>(i, X) + boost<2>(j, X))
                                : 0.5 * (boost<3>(i, X) + boost<3>(j, X));
}

/* ----------------------------------------------------------------------
   of bonds along faces near i
------------------------------------------------------------------------- */

template <int D> double TMSPHFlatFaces::boost(int i, const double *X) const
{
  double product = 1.0;
  const int faces = count(i);
  for (int k = 0; k < faces; k++) {
    const Layer<D> found = layer<D>(i, k);
    if (found.along(X)) product *= 1.0 + found.boost;
  }
  return product;
}

/* ---------------------------------------------------------------------- */

int TMSPHFlatFaces::layer_size() const
{
  return domain->dimension == 2 ? Layer<2>::SIZE : Layer<3>::SIZE;
}

/* ---------------------------------------------------------------------- */

int TMSPHFlatFaces::row_size() const
{
  return domain->dimension * layer_size();
}

/* ----------------------------------------------------------------------
   a layer that a particle has is above 0, see Layer::put()
------------------------------------------------------------------------- */

int TMSPHFlatFaces::count(int i) const
{
  const double *layers = row(i);
  int faces = 0;
  while (layers && faces < domain->dimension &&
         layers[faces * layer_size() + domain->dimension] > 0.0)
    faces++;
  return faces;
}

/* ----------------------------------------------------------------------
   @return zeros to be filled
------------------------------------------------------------------------- */

double *TMSPHFlatFaces::make_row(int i)
{
  const size_t before = rows.size();
  face_row[i] = before / row_size();
  rows.resize(before + row_size(), 0.0);
  return &rows[before];
}

/* ---------------------------------------------------------------------- */

void TMSPHFlatFaces::drop_all()
{
  faced = false;
  std::fill(face_row.begin(), face_row.end(), (int) NONE);
  rows.clear();
}

/* ----------------------------------------------------------------------
   leaves those of local particles, in their order
------------------------------------------------------------------------- */

void TMSPHFlatFaces::keep_local()
{
  std::vector<double> before;
  before.swap(rows);
  std::vector<int> where(face_row.begin(), face_row.begin() + atom->nlocal);
  std::fill(face_row.begin(), face_row.end(), (int) NONE);
  const int size = row_size();
  for (int i = 0; i < atom->nlocal; i++)
    if (where[i] != NONE) std::copy_n(&before[(size_t) where[i] * size], size, make_row(i));
}

/* ----------------------------------------------------------------------
   Only a body on a lattice has faces, and particles more than one at edges only:
   one after the other is sent.
------------------------------------------------------------------------- */

void TMSPHFlatFaces::complete()
{
  keep_local();
  int mine = 0, most_faces;
  for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, count(i));
  MPI_Allreduce(&mine, &most_faces, 1, MPI_INT, MPI_MAX, world);
  faced = most_faces > 0;
  const int size = layer_size();
  TMSPHGhostRows sent(size);
  for (int k = 0; k < most_faces; k++) {
    sent.fill(atom->nlocal, 0.0);
    for (int i = 0; i < atom->nlocal; i++)
      if (row(i)) std::copy_n(row(i) + k * size, size, sent[i]);
    ghosts.complete(sent);
    take_of_ghosts(sent, k);
  }
  rows.shrink_to_fit();
}

/* ----------------------------------------------------------------------
   @param k of the layer that was sent
------------------------------------------------------------------------- */

void TMSPHFlatFaces::take_of_ghosts(const TMSPHGhostRows &sent, int k)
{
  const int size = layer_size();
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++) {
    if (!(sent[i][domain->dimension] > 0.0)) continue;
    if (k == 0) make_row(i);
    std::copy_n(sent[i], size, &rows[(size_t) face_row[i] * row_size() + k * size]);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHFlatFaces::grow(int nmax)
{
  face_row.reserve(nmax);    // and no more
  face_row.resize(nmax, NONE);
}

/* ----------------------------------------------------------------------
   number of faces, then each
------------------------------------------------------------------------- */

int TMSPHFlatFaces::pack(int i, double *buf) const
{
  const int faces = count(i);
  buf[0] = faces;
  if (faces) std::copy_n(row(i), faces * layer_size(), buf + 1);
  return 1 + faces * layer_size();
}

/* ---------------------------------------------------------------------- */

int TMSPHFlatFaces::unpack(int i, const double *buf)
{
  const int faces = (int) buf[0];
  face_row[i] = NONE;
  if (faces) std::copy_n(buf + 1, faces * layer_size(), make_row(i));
  return 1 + faces * layer_size();
}

/* ---------------------------------------------------------------------- */

double TMSPHFlatFaces::bytes() const
{
  return rows.capacity() * sizeof(double) + face_row.capacity() * sizeof(int);
}
