/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_materials.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "math_const.h"
#include "text_file_reader.h"
#include "tmsph_types.h"
#include "tokenizer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

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
   @return index of the word after it
------------------------------------------------------------------------- */

static int read_property(LAMMPS *lmp, const std::string &word, int iarg, int narg, char **arg,
                         PropertyTable &property)
{
  Error *error = lmp->error;
  if (strcmp(arg[iarg], "table") == 0) {
    if (iarg + 2 >= narg)
      utils::missing_cmd_args(FLERR, "fix tmsph/heat " + word + " table", error);
    std::vector<double> T, values;
    std::string trouble;
    if (lmp->comm->me == 0) {
      trouble = read_table(arg[iarg + 1], arg[iarg + 2], T, values);
      for (size_t n = 0; n < T.size() && trouble.empty(); n++) {
        if (n && !(T[n] > T[n - 1]))
          trouble = fmt::format("temperatures must ascend, but {} comes after {}", T[n], T[n - 1]);
        if (!(values[n] > 0.0))
          trouble = fmt::format("value {} at temperature {} must be positive", values[n], T[n]);
      }
    }
    int size[2] = {(int) T.size(), (int) trouble.size()};
    MPI_Bcast(size, 2, MPI_INT, 0, lmp->world);
    trouble.resize(size[1]);
    MPI_Bcast(&trouble[0], size[1], MPI_CHAR, 0, lmp->world);
    if (size[1])
      error->all(FLERR, "Table {} of fix tmsph/heat {}: {}", arg[iarg + 1], word, trouble);
    T.resize(size[0]);
    values.resize(size[0]);
    MPI_Bcast(T.data(), size[0], MPI_DOUBLE, 0, lmp->world);
    MPI_Bcast(values.data(), size[0], MPI_DOUBLE, 0, lmp->world);
    property = PropertyTable(T, values);
    return iarg + 3;
  }
  const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
  if (!(value > 0.0 && std::isfinite(value)))
    error->all(FLERR, "Fix tmsph/heat {} {} must be positive", word, arg[iarg]);
  property = PropertyTable(value);
  return iarg + 1;
}

/* ----------------------------------------------------------------------
   a number, a table, or the principal values and the turn of their axes: in 2-D
   orthotropic k1 k2 angle, in 3-D orthotropic k1 k2 k3 axis-x axis-y axis-z angle
------------------------------------------------------------------------- */

int TMSPHHeatMaterials::read_conductivity(int iarg, int narg, char **arg, Material &m)
{
  if (strcmp(arg[iarg], "orthotropic") != 0)
    return read_property(lmp, "conductivity", iarg, narg, arg, m.conductivity);
  const int dimension = domain->dimension, words = dimension == 2 ? 3 : 7;
  if (iarg + words >= narg)
    utils::missing_cmd_args(FLERR, "fix tmsph/heat conductivity orthotropic", error);
  double n[7];
  for (int k = 0; k < words; k++) n[k] = utils::numeric(FLERR, arg[iarg + 1 + k], false, lmp);
  Eigen::Vector3d values(n[0], n[1], dimension == 2 ? n[0] : n[2]), axis(0.0, 0.0, 1.0);
  for (int k = 0; k < dimension; k++)
    if (!(values[k] > 0.0 && std::isfinite(values[k])))
      error->all(FLERR, "Fix tmsph/heat conductivity {} must be positive", arg[iarg + 1 + k]);
  if (dimension == 3) axis = Eigen::Vector3d(n[3], n[4], n[5]);
  if (!(axis.norm() > 0.0))
    error->all(FLERR, "The axis by which the principal directions of fix tmsph/heat conductivity "
                      "orthotropic turn has no length: for no turn use 0 0 1 0");
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(n[words - 1] * MathConst::DEG2RAD, axis.normalized()).toRotationMatrix();
  const Eigen::Matrix3d K = turn * values.asDiagonal() * turn.transpose();
  Eigen::Map<Eigen::Matrix3d>(m.tensor) = 0.5 * (K + K.transpose());
  m.orthotropic = true;
  m.conductivity = PropertyTable(values.maxCoeff());
  return iarg + 1 + words;
}

/* ---------------------------------------------------------------------- */

int TMSPHHeatMaterials::read(const std::string &word, int iarg, int narg, char **arg)
{
  int lo, hi, next;
  TMSPH::read_types(lmp, "Fix tmsph/heat " + word, word + " * value", arg[iarg], lo, hi);
  Material given;
  const bool conducts = word == "conductivity";
  if (conducts)
    next = read_conductivity(iarg + 1, narg, arg, given);
  else
    next = read_property(lmp, word, iarg + 1, narg, arg, given.specific_heat);
  for (int type = lo; type <= hi; type++) {
    Material &m = materials[type];
    if (conducts) {
      m.conductivity = given.conductivity;
      m.orthotropic = given.orthotropic;
      std::copy_n(given.tensor, 9, m.tensor);
    } else
      m.specific_heat = given.specific_heat;
  }
  return next;
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
  for (int i = 0; i < atom->nlocal; i++)
    sum += atom->rmass[i] * enthalpy(i, atom->temperature[i]);
  return sum;
}
