/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The numbers in force-styles/tests/pair-tmsph_*.yaml, which LAMMPS's tester
   holds the pair style to, are those of the plain double loop: forces, energy
   and virial of the deformed body, and again after four steps of Verlet.
------------------------------------------------------------------------- */

#include "double_loop.h"
#include "tmsph_dilatation.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

using namespace TMSPH;
using namespace TMSPH_TEST;

namespace {

const std::filesystem::path FOLDER = TMSPH_FORCE_STYLES;

using Lines = std::vector<std::string>;
using Words = std::vector<std::string>;

Words split(const std::string &line)
{
  std::istringstream in(line);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// the keys of a YAML test; a block has a line for each of its own
std::map<std::string, Lines> read_yaml(const std::filesystem::path &file)
{
  std::map<std::string, Lines> yaml;
  std::ifstream in(file);
  std::string key;
  for (std::string line; std::getline(in, line);) {
    const size_t colon = line.find(':');
    if (line[0] == ' ')
      yaml[key].push_back(line);
    else if (colon != std::string::npos) {
      key = line.substr(0, colon);
      const std::string value = line.substr(colon + 1);
      if (value.find('|') == std::string::npos) yaml[key].push_back(value);
    }
  }
  return yaml;
}

/// the sections of a data file, each line as numbers; the lines before the first under ""
std::map<std::string, std::vector<std::vector<double>>> read_data(const std::string &name)
{
  std::map<std::string, std::vector<std::vector<double>>> sections;
  std::ifstream in(FOLDER / name);
  std::string section;
  std::getline(in, section);    // title
  section.clear();
  for (std::string line; std::getline(in, line);) {
    const Words words = split(line);
    if (words.empty()) continue;
    if (std::isalpha(words[0][0])) {
      section = words[0];
      continue;
    }
    std::vector<double> numbers;
    for (const auto &word : words)
      if (!std::isalpha(word[0])) numbers.push_back(std::stod(word));
    sections[section].push_back(numbers);
  }
  return sections;
}

struct Scene {
  Features on;
  Viscosity viscosity;
  Kernel kernel;
  Plane plane = Plane::STRAIN;
  double horizon = 0.0, hourglass = 0.1;
  Dilatation dilatation = Dilatation::AUTO;

  explicit Scene(const Words &style)    // tmsph horizon keyword value ...
  {
    bool strain = false;
    horizon = std::stod(style.at(1));
    for (size_t k = 2; k < style.size(); k += 2) {
      const std::string &word = style[k], &value = style.at(k + 1);
      if (word == "kernel")
        for (const auto &each : kernels()) {
          if (each.first == value) kernel = each.second;
        }
      else if (word == "plane")
        plane = value == "stress" ? Plane::STRESS : Plane::STRAIN;
      else if (word == "law")
        for (const auto &each : alternatives<ElasticLaw>()) {
          if (each.first == value) on.law = each.second;
        }
      else if (word == "thermal")
        strain = value == "strain";
      else if (word == "hourglass")
        hourglass = std::stod(value);
      else if (word == "dilatation")
        dilatation = value == "plain" ? Dilatation::PLAIN
            : value == "averaged"     ? Dilatation::AVERAGED
                                      : Dilatation::AUTO;
      else if (word == "viscosity") {
        viscosity.alpha1 = std::stod(value);
        viscosity.alpha2 = std::stod(style.at(k++ + 2));
        on.viscosity = true;
      } else
        ADD_FAILURE() << "unknown keyword " << word;
    }
    if (!std::holds_alternative<StVenantKirchhoff>(on.law) || plane == Plane::STRESS)
      dilatation = Dilatation::PLAIN;
    on.thermal = strain ? ThermalStrain::CONSTITUTIVE : ThermalStrain::BOND;
    on.hourglass = hourglass > 0.0;
    viscosity.smoothing_length = horizon / support_in_smoothing_lengths(kernel);
  }
};

/// does the bond from a to b cross the segment from p to q? Both pairs lie on opposite sides.
bool crosses(const Vector<2> &a, const Vector<2> &b, const Vector<2> &p, const Vector<2> &q)
{
  const auto side = [](const Vector<2> &from, const Vector<2> &to, const Vector<2> &x) {
    const Vector<2> d = to - from, r = x - from;
    return d[0] * r[1] - d[1] * r[0] > 0.0;
  };
  return side(p, q, a) != side(p, q, b) && side(a, b, p) != side(a, b, q);
}

template <int D> void check(const std::map<std::string, Lines> &yaml, const std::string &geometry)
{
  Scene scene(split(yaml.at("pair_style")[0]));
  auto data = read_data("data.tmsph_" + geometry);

  // materials by type: I J elastic E nu density rho [expansion alpha reference T0] or I J none
  struct Coefficients {
    Elastic elastic;
    double density = 0.0, reference = 0.0;
  };
  std::map<int, Coefficients> materials;
  bool bonded = true;
  for (const auto &line : yaml.at("pair_coeff")) {
    const Words word = split(line);
    if (word.at(2) == "none") bonded = false;
    if (word.at(2) != "elastic") continue;
    std::map<std::string, double> option;
    for (size_t k = 5; k + 1 < word.size(); k += 2) option[word[k]] = std::stod(word[k + 1]);
    materials[std::stoi(word[0])] = {elastic_constants(D, scene.plane, std::stod(word[3]),
                                                       std::stod(word[4]), option["expansion"]),
                                     option["density"], option["reference"]};
  }

  // a periodic body is repeated twice to each side: the bonds of bonds stay inside
  const int n = (int) data["Atoms"].size(), copies = geometry == "periodic" ? 2 : 0;
  const double period = data[""].at(2).at(1) - data[""].at(2).at(0);
  Body<D> body;
  body.horizon = scene.horizon;
  std::vector<int> type;
  for (int copy = -copies; copy <= copies; copy++)
    for (int i = 0; i < n; i++) {
      const auto &atom = data["Atoms"][i];    // id type volume mass temperature x y z
      const Coefficients &m = materials[(int) atom.at(1)];
      Particle<D> p;
      for (int k = 0; k < D; k++) {
        p.X[k] = data["reference"][i].at(1 + k);
        p.u[k] = atom.at(5 + k) - p.X[k];
        p.v[k] = data["Velocities"][i].at(1 + k);
      }
      p.X[0] += copy * period;
      p.volume = atom.at(2);
      p.density = m.density;
      p.material = m.elastic;
      p.thermal = m.elastic.expansion * (atom.at(4) - m.reference);
      p.type = (int) atom.at(1);
      p.averaged = scene.dilatation == Dilatation::AVERAGED ||
          (scene.dilatation == Dilatation::AUTO && m.elastic.poisson > 0.4);
      body.p.push_back(p);
      type.push_back((int) atom.at(1));
    }
  body.form_bonds(scene.kernel);
  int gone = 0;
  const auto remove_if = [&](auto condition) {
    for (int i = 0; i < body.size(); i++)
      for (int j = 0; j < body.size(); j++)
        if (body.W(i, j) != 0.0f && condition(i, j)) {
          body.W(i, j) = 0.0f;
          gone++;
        }
  };
  remove_if([&](int i, int j) { return !bonded && type[i] != type[j]; });
  scene.viscosity.kappa = body.kappa();    // of the body before it is cut
  const Words command = split(yaml.at("post_commands")[0]);
  const auto cut = std::find(command.begin(), command.end(), "\"tmsph/cut");    // all line x y x y
  if constexpr (D == 2)
    if (cut != command.end())
      remove_if([&](int i, int j) {
        return crosses(body.p[i].X, body.p[j].X, {std::stod(cut[3]), std::stod(cut[4])},
                       {std::stod(cut[5]), std::stod(cut[6])});
      });
  EXPECT_EQ(gone > 0, !bonded || cut != command.end());

  body.average(scene.kernel, scene.viscosity.kappa);

  // accuracy: round-off, which the tester's epsilon is meant to allow, too
  const auto compare = [&](const std::string &when, const Answer<D> &exact, double tolerance) {
    SCOPED_TRACE(when);
    const double largest = largest_of(exact.force);
    ASSERT_EQ((int) yaml.at(when + "_forces").size(), n);
    double energy = 0.0;
    Square<D> virial = Square<D>::Zero();
    for (int i = 0; i < n; i++) {
      const int at = copies * n + i;
      const Words row = split(yaml.at(when + "_forces")[i]);    // id fx fy fz, by id as the data
      for (int k = 0; k < 3; k++)
        EXPECT_NEAR(std::stod(row.at(1 + k)), k < D ? exact.force[at][std::min(k, D - 1)] : 0.0,
                    tolerance * largest)
            << "particle " << row[0];
      energy += exact.energy[at];
      virial += exact.virial[at];
    }
    EXPECT_NEAR(std::stod(yaml.at(when + "_vdwl")[0]) / energy, 1.0, tolerance);
    const Words row = split(yaml.at(when + "_stress")[0]);    // xx yy zz xy xz yz
    const int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++)
        EXPECT_NEAR(std::stod(row.at(place[a][b])), virial(a, b), tolerance * virial.norm());
  };
  const auto evaluate = [&]() {
    return double_loop(body, scene.on, scene.hourglass, scene.viscosity);
  };
  Answer<D> answer = evaluate();
  compare("init", answer, 1.0e-12);

  const double dt = 5.0e-8;    // of in.tmsph; the viscosity sees the velocities of the half step
  for (int step = 0; step < 4; step++) {
    const auto kick = [&]() {
      for (int i = 0; i < body.size(); i++) {
        Particle<D> &p = body.p[i];    // copies move with their originals
        p.v += 0.5 * dt / (p.density * p.volume) * answer.force[copies * n + i % n];
      }
    };
    kick();
    for (auto &p : body.p) p.u += dt * p.v;
    answer = evaluate();
    kick();
  }
  compare("run", answer, 1.0e-11);    // round-off of four steps
}

TEST(ReferenceForces, equal_the_double_loop)
{
  int files = 0;
  for (const auto &entry : std::filesystem::directory_iterator(FOLDER)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("pair-tmsph_", 0) != 0 || entry.path().extension() != ".yaml") continue;
    files++;
    SCOPED_TRACE(name);
    const auto yaml = read_yaml(entry.path());
    const Words first = split(yaml.at("pre_commands")[0]);    // variable geometry index NAME
    ASSERT_EQ(first.at(1), "geometry");
    if (first.at(3) == "3d")
      check<3>(yaml, first[3]);
    else
      check<2>(yaml, first[3]);
  }
  EXPECT_GT(files, 0);
}

}    // namespace
