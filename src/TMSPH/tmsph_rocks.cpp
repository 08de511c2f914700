/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_rocks.h"

#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "tmsph_materials.h"
#include "tmsph_random.h"
#include "tmsph_words.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using TMSPH::Principals;

/* ---------------------------------------------------------------------- */

TMSPHRocks::TMSPHRocks(LAMMPS *lmp, std::unique_ptr<TMSPH::Criterion> criterion) :
    Pointers(lmp), law(std::move(criterion)), rocks(atom->ntypes + 1)
{
}

/* ---------------------------------------------------------------------- */

void TMSPHRocks::read(const std::string &style, char **next, char **last)
{
  const auto &constants = law->words();
  std::vector<std::vector<double>> values(atom->ntypes + 1);
  for (auto &one : values)
    for (const auto &constant : constants) one.push_back(constant.standard);
  std::vector<TMSPHWord> words;
  for (size_t k = 0; k < constants.size(); k++)
    words.push_back({constants[k].name, "I value", [&values, &constants, k](TMSPHValues &v) {
                       int lo, hi;
                       v.types(lo, hi);
                       const double value =
                           v.number(constants[k].allows,
                                    fmt::format("is out of range: {}", constants[k].rule));
                       for (int type = lo; type <= hi; type++) values[type][k] = value;
                     }});
  const auto opens_with = [this](double Rock::*given, double Rock::*other) {
    return [this, given, other](TMSPHValues &v) {
      int lo, hi;
      v.types(lo, hi);
      const double value = v.number(TMSPHRule::positive, "is out of range: it must be positive");
      for (int type = lo; type <= hi; type++) {
        rocks[type].*given = value;
        rocks[type].*other = 0.0;
      }
    };
  };
  words.push_back({"energy", "I value", opens_with(&Rock::energy, &Rock::toughness)});
  words.push_back({"toughness", "I value", opens_with(&Rock::toughness, &Rock::energy)});
  words.push_back({"between", "I J [energy/toughness/strength value ...]",
                   [this](TMSPHValues &v) { read_between(v); }});
  words.push_back({"weibull", "I modulus seed", [this](TMSPHValues &v) { read_weibull(v); }});
  words.push_back({"scatter", "strength/both", [this](TMSPHValues &v) {
                     energies_scatter = v.one_of<bool>({{"strength", false}, {"both", true}});
                   }});
  words.push_back({"softening", "linear/bilinear", [this](TMSPHValues &v) {
                     cohesion = v.one_of(TMSPH::alternatives<TMSPH::CohesiveLaw>());
                   }});
  words.push_back({"principal", "inplane/all", [this](TMSPHValues &v) {
                     all_principals = v.one_of<bool>({{"inplane", false}, {"all", true}});
                   }});
  TMSPHWords(lmp, "fix " + style, std::move(words)).read_all(next, last);

  for (int type = 1; type <= atom->ntypes; type++) {
    for (size_t k = 0; k < constants.size(); k++)
      if (values[type][k] == TMSPH::REQUIRED)
        error->all(FLERR, "Fix {} lacks the {} of type {}: add '{} {} value'", style,
                   constants[k].name, type, constants[k].name, type);
    rocks[type].strength = values[type][0];
    law->add(values[type]);
    one_rock = one_rock && law->alike(type, 1);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHRocks::read_weibull(TMSPHValues &values)
{
  int lo, hi;
  values.types(lo, hi);
  // (-ln U)^(1/omega) and its square must be numbers for all U of double precision
  const double modulus =
      values.number([](double value) { return value >= 0.1; },
                    "is out of range: the Weibull modulus must be at least 0.1; 10 is usual");
  const int seed = values.integer();
  if (seed <= 0) values.reject(fmt::format("seed {}", seed), "must be a positive integer");
  for (int type = lo; type <= hi; type++) {
    rocks[type].modulus = modulus;
    rocks[type].seed = seed;
  }
}

/* ----------------------------------------------------------------------
   energy, toughness, strength with one number are of the pair: those of types take two values
------------------------------------------------------------------------- */

void TMSPHRocks::read_between(TMSPHValues &values)
{
  int lo, hi, other_lo, other_hi;
  char **const start = values.rest();
  values.types(lo, hi);
  values.types(other_lo, other_hi);
  const std::string pair = fmt::format("{} {}", start[0], start[1]);
  Between given;
  const std::pair<const char *, double Between::*> table[] = {{"energy", &Between::energy},
                                                              {"toughness", &Between::toughness},
                                                              {"strength", &Between::tensile}};
  bool words = false;
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const auto &[word, value] : table) {
      if (!values.word_of_one_number(word)) continue;
      given.*value = values.number();
      if (!TMSPHRule::positive(given.*value))
        values.reject(fmt::format("{} {} {}", pair, word, values.rest()[-1]),
                      "is out of range: it must be positive");
      words = goes_on = true;
    }
  }
  if (!words)
    values.reject(pair,
                  "lacks what bonds between the two have: add 'energy', 'toughness' or "
                  "'strength' with one value each");
  if (given.energy > 0.0 && given.toughness > 0.0)
    values.reject(pair, "has an energy and a toughness: give one of them");
  bool any = false;
  for (int type = lo; type <= hi; type++)
    for (int other = other_lo; other <= other_hi; other++) {
      if (type == other) continue;
      between[std::minmax(type, other)] = given;
      any = true;
    }
  if (!any)
    values.reject(pair, "needs two types: what bonds of one have is given by the words without it");
}

/* ---------------------------------------------------------------------- */

/* ---------------------------------------------------------------------- */

void TMSPHRocks::init(const TMSPHMaterials &present)
{
  materials = &present;
  if (domain->dimension == 3) all_principals = false;    // 3-D has all anyway
  for (int type = 1; type <= atom->ntypes; type++) {
    Rock &rock = rocks[type];
    const double pull[6] = {rock.strength};    // what a test would give the criterion
    rock.tensile = 1.0 / law->load_factor(type, type, principals(pull, 0.0), rock.strength);
  }
  for (int type = 1; type <= atom->ntypes; type++) {
    rocks[type].weakest = 1.0;
    for (int other = 1; other <= atom->ntypes; other++)
      rocks[type].weakest = std::min(rocks[type].weakest, strength_factor(type, other));
  }
  version = -1;
}

TMSPHRocks::Between TMSPHRocks::given(int type, int other) const
{
  const auto found = between.find(std::minmax(type, other));
  return found == between.end() ? Between() : found->second;
}

/* ---------------------------------------------------------------------- */

double TMSPHRocks::tensile_strength() const
{
  double smallest = HUGE_VAL;
  for (int type = 1; type <= atom->ntypes; type++)
    for (int other = type; other <= atom->ntypes; other++)
      smallest = std::min(smallest, tensile_strength(type, other));
  return smallest;
}

/* ---------------------------------------------------------------------- */

double TMSPHRocks::tensile_strength(int type, int other) const
{
  const double tensile = given(type, other).tensile;
  if (tensile > 0.0) return tensile;
  return 0.5 *
      (rocks[type].strength * rocks[type].tensile + rocks[other].strength * rocks[other].tensile);
}

/* ---------------------------------------------------------------------- */

double TMSPHRocks::strength_factor(int type, int other) const
{
  if (!of_pair(type, other)) return 1.0;
  return 2.0 * tensile_strength(type, other) /
      (tensile_strength(type, type) + tensile_strength(other, other));
}

/* ---------------------------------------------------------------------- */

bool TMSPHRocks::opens(int type, int other) const
{
  const auto opens_itself = [this](int one) {
    return rocks[one].energy > 0.0 || rocks[one].toughness > 0.0;
  };
  const Between own = given(type, other);
  return own.energy > 0.0 || own.toughness > 0.0 || (opens_itself(type) && opens_itself(other));
}

/* ---------------------------------------------------------------------- */

bool TMSPHRocks::opens(int type) const
{
  for (int other = 1; other <= atom->ntypes; other++)
    if (opens(type, other)) return true;
  return false;
}

/* ---------------------------------------------------------------------- */

bool TMSPHRocks::any_opens() const
{
  for (int type = 1; type <= atom->ntypes; type++)
    if (opens(type)) return true;
  return false;
}

/* ----------------------------------------------------------------------
   K^2 = E G in plane stress, E/(1 - nu^2) G else. Between types without values of their own the
   mean, where both have one.
------------------------------------------------------------------------- */

double TMSPHRocks::crack_energy(int type, int other) const
{
  const auto energy = [&](double G, double K) {
    return K > 0.0 ? K * K / crack_modulus(type, other) : G;
  };
  if (type == other) return energy(rocks[type].energy, rocks[type].toughness);
  const Between own = given(type, other);
  if (own.energy > 0.0 || own.toughness > 0.0) return energy(own.energy, own.toughness);
  const double one = crack_energy(type, type), two = crack_energy(other, other);
  return one > 0.0 && two > 0.0 ? 0.5 * (one + two) : 0.0;
}

double TMSPHRocks::crack_modulus(int type, int other) const
{
  const bool plane_stress =
      domain->dimension == 2 && materials->words().plane == TMSPH::Plane::STRESS;
  const auto modulus = [&](int one) {
    const auto &m = materials->material(one).elastic;
    return plane_stress ? m.young : TMSPH::plane_modulus(m);
  };
  return 0.5 * (modulus(type) + modulus(other));
}

/* ---------------------------------------------------------------------- */

double TMSPHRocks::characteristic_length(int type, int other) const
{
  const double tensile = tensile_strength(type, other);
  const double young = 0.5 * (materials->material(type).young + materials->material(other).young);
  return young * crack_energy(type, other) / (tensile * tensile);
}

/* ---------------------------------------------------------------------- */

double TMSPHRocks::energy_factor(int i, int j) const
{
  if (!energies_scatter) return 1.0;
  const auto drawn = [this](int p) { return strengths[p] / rocks[atom->type[p]].strength; };
  return 0.5 * (drawn(i) + drawn(j));
}

/* ----------------------------------------------------------------------
   by first ids
------------------------------------------------------------------------- */

bool TMSPHRocks::follow(const FixTMSPHBond &bonds, TMSPHGhostSender &ghosts)
{
  if (version == bonds.layout_version()) return false;
  version = bonds.layout_version();
  strengths.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) {
    const Rock &rock = rocks[atom->type[i]];
    strengths[i] = rock.modulus > 0.0
        ? TMSPH::weibull_random(rock.strength, rock.modulus, bonds.first_id(i), rock.seed)
        : rock.strength;
  }
  ghosts.complete(strengths);
  return true;
}

/* ---------------------------------------------------------------------- */

Principals TMSPHRocks::principals(const double *row, double zz) const
{
  if (domain->dimension == 3) return TMSPH::principals_3d(row);
  const Principals p = TMSPH::principals_2d(row);
  if (!all_principals) return p;
  return {std::max(p.largest, zz), std::max(p.smallest, std::min(p.largest, zz)),
          std::min(p.smallest, zz)};
}

/* ---------------------------------------------------------------------- */

Principals TMSPHRocks::principals(int i, const double *row) const
{
  return principals(row, all_principals ? materials->stress_zz(i, row[0], row[1]) : 0.0);
}

/* ---------------------------------------------------------------------- */

Principals TMSPHRocks::principals(int i, int j, const double *row_i, const double *row_j,
                                  const double *mean) const
{
  double zz = 0.0;
  if (all_principals)
    zz = 0.5 *
        (materials->stress_zz(i, row_i[0], row_i[1]) + materials->stress_zz(j, row_j[0], row_j[1]));
  return principals(mean, zz);
}

/* ---------------------------------------------------------------------- */

bool TMSPHRocks::may_fail(int i, const double *row) const
{
  if (all_principals) return true;
  const bool two = domain->dimension == 2;
  const TMSPH::Invariants v = two ? TMSPH::invariants_2d(row) : TMSPH::invariants_3d(row);
  return law->may_fail(atom->type[i], v, two ? 1.0 : TMSPH::REACH_3D, strengths[i]);
}

/* ---------------------------------------------------------------------- */

bool TMSPHRocks::fails(int i, const double *row) const
{
  const int type = atom->type[i];
  return may_fail(i, row) && law->fails(type, type, principals(i, row), strengths[i]);
}

/* ---------------------------------------------------------------------- */

double TMSPHRocks::load_factor_of_all(int i, const double *stress) const
{
  const double plane[3] = {stress[0], stress[1], stress[3]};
  const bool space = domain->dimension == 3;
  return load_factor(i, space ? TMSPH::principals_3d(stress) : principals(plane, stress[2]));
}
