/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_materials.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "math_const.h"
#include "text_file_reader.h"
#include "tmsph_words.h"
#include "tokenizer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using TMSPH::PropertyTable;

/* ----------------------------------------------------------------------
   lines 'temperature value' after the name of the section, up to a line of one word
   @return what is wrong, or nothing
------------------------------------------------------------------------- */

static std::string read_table(const char *file, const std::string &section, std::vector<double> &T,
                              std::vector<double> &values)
{
  try {
    const std::string path = utils::get_potential_file_path(file);
    TextFileReader reader(path.empty() ? file : path, "table");
    char *line;
    while ((line = reader.next_line()) && ValueTokenizer(line).next_string() != section) {}
    if (!line) return fmt::format("it has no section {}", section);
    while ((line = reader.next_line())) {
      ValueTokenizer words(line);
      if (words.count() == 1) break;
      if (words.count() != 2)
        return fmt::format("lines must be 'temperature value', not '{}'", utils::trim(line));
      T.push_back(words.next_double());
      values.push_back(words.next_double());
    }
  } catch (std::exception &e) {
    return e.what();
  }
  return T.empty() ? "its section has no lines 'temperature value'" : "";
}

/* ----------------------------------------------------------------------
   a positive number, or a table of positive numbers over temperature
------------------------------------------------------------------------- */

PropertyTable TMSPHHeatMaterials::read_property(const char *name, TMSPHValues &given) const
{
  if (!given.word("table", "file section"))
    return PropertyTable(given.number(TMSPHRule::positive, "must be positive"));
  const char *const file = given.text(), *const section = given.text();
  std::vector<double> T, values;
  std::string trouble;
  if (comm->me == 0) {
    trouble = read_table(file, section, T, values);
    for (size_t n = 0; n < T.size() && trouble.empty(); n++) {
      if (n && !(T[n] > T[n - 1]))
        trouble = fmt::format("temperatures must ascend, but {} comes after {}", T[n], T[n - 1]);
      if (!(values[n] > 0.0))
        trouble = fmt::format("value {} at temperature {} must be positive", values[n], T[n]);
    }
  }
  int size[2] = {(int) T.size(), (int) trouble.size()};
  MPI_Bcast(size, 2, MPI_INT, 0, world);
  trouble.resize(size[1]);
  MPI_Bcast(&trouble[0], size[1], MPI_CHAR, 0, world);
  if (size[1]) error->all(FLERR, "Table {} of fix tmsph/heat {}: {}", file, name, trouble);
  T.resize(size[0]);
  values.resize(size[0]);
  MPI_Bcast(T.data(), size[0], MPI_DOUBLE, 0, world);
  MPI_Bcast(values.data(), size[0], MPI_DOUBLE, 0, world);
  return PropertyTable(T, values);
}

/* ----------------------------------------------------------------------
   the principal values and the turn of their axes: in 2-D k1 k2 angle, in 3-D
   k1 k2 k3 axis-x axis-y axis-z angle
------------------------------------------------------------------------- */

void TMSPHHeatMaterials::read_tensor(TMSPHValues &given, Material &m) const
{
  const int dimension = domain->dimension;
  Eigen::Vector3d values, axis(0.0, 0.0, 1.0);
  for (int k = 0; k < dimension; k++)
    values[k] = given.number(TMSPHRule::positive, "must be positive");
  if (dimension == 2)
    values[2] = values[0];
  else
    for (int k = 0; k < 3; k++) axis[k] = given.number();
  if (!(axis.norm() > 0.0))
    error->all(FLERR,
               "The axis by which the principal directions of fix tmsph/heat conductivity "
               "orthotropic turn has no length: for no turn use 0 0 1 0");
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(given.number() * MathConst::DEG2RAD, axis.normalized()).toRotationMatrix();
  const Eigen::Matrix3d K = turn * values.asDiagonal() * turn.transpose();
  Eigen::Map<Eigen::Matrix3d>(m.tensor) = 0.5 * (K + K.transpose());
  m.orthotropic = true;
  m.conductivity = PropertyTable(values.maxCoeff());
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatMaterials::read_conductivity(TMSPHValues &values)
{
  int lo, hi;
  values.types(lo, hi);
  Material given;
  if (values.word("orthotropic",
                  domain->dimension == 2 ? "k1 k2 angle" : "k1 k2 k3 axis-x axis-y axis-z angle"))
    read_tensor(values, given);
  else
    given.conductivity = read_property("conductivity", values);
  for (int type = lo; type <= hi; type++) {
    given.specific_heat = materials[type].specific_heat;
    materials[type] = given;
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatMaterials::read_specific_heat(TMSPHValues &values)
{
  int lo, hi;
  values.types(lo, hi);
  const PropertyTable given = read_property("specific/heat", values);
  for (int type = lo; type <= hi; type++) materials[type].specific_heat = given;
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatMaterials::check()
{
  bool any_orthotropic = false;
  for (int type = 1; type <= atom->ntypes; type++) {
    const Material &m = materials[type];
    if (!(m.conductivity.smallest() > 0.0))
      error->all(FLERR, "Fix tmsph/heat lacks the conductivity of type {}: add 'conductivity {} k'",
                 type, type);
    if (!(m.specific_heat.smallest() > 0.0))
      error->all(FLERR,
                 "Fix tmsph/heat lacks the specific heat of type {}: add 'specific/heat {} c'",
                 type, type);
    tables = tables || !m.conductivity.constant();
    any_orthotropic = any_orthotropic || m.orthotropic;
  }
  if (tables && any_orthotropic)
    error->all(FLERR,
               "Fix tmsph/heat cannot have both orthotropic conductivities and conductivities "
               "from tables: give numbers instead of tables");
}

/* ----------------------------------------------------------------------
   n.K.n: the flux along n in a field that varies along n only
------------------------------------------------------------------------- */

double TMSPHHeatMaterials::conductivity_of(int i, const double *direction) const
{
  const Material &m = materials[atom->type[i]];
  if (!m.orthotropic) return m.conductivity(atom->temperature[i]);
  double k = 0.0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) k += direction[a] * m.tensor[3 * a + b] * direction[b];
  return k;
}

/* ---------------------------------------------------------------------- */

double TMSPHHeatMaterials::enthalpy(int i, double temperature) const
{
  return specific_heat(atom->type[i]).integral(temperature);
}

/* ---------------------------------------------------------------------- */

double TMSPHHeatMaterials::content() const
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++) sum += atom->rmass[i] * enthalpy(i, atom->temperature[i]);
  return sum;
}
