package org.u2sa.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeSet;
import java.util.function.Function;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.bearing.BearingModeller;
import org.u2sa.world.coverage.CoverageModeller;
import org.u2sa.world.egocentric.EgocentricModeller;
import org.u2sa.world.grid.GridModeller;
import org.u2sa.world.landmark.LandmarkModeller;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.ModellerProvider;
import org.u2sa.world.modeller.Sighting;
import org.u2sa.world.object.ObjectMapModeller;
import org.u2sa.world.scanmap.ScanMapModeller;

/** The modellers selected by MODELLERS. */
final class ChosenModellers {
  static final String REACTIVE = "REACTIVE";
  static final String OBJECTS = "OBJECTS";
  static final String GRID = "GRID";
  static final String SCAN_MAP = "SCAN MAP";
  static final String LANDMARKS = "LANDMARKS";
  static final String EGOCENTRIC = "EGOCENTRIC";
  static final String BEARINGS = "BEARINGS";
  static final String COVERAGE = "COVERAGE";

  private final Map<String, Modeller> all = new LinkedHashMap<>();
  private Map<String, Modeller> chosen = new LinkedHashMap<>();

  /**
   * @param configuration configuration of the World Modeler, in which all modellers declare their
   *     variables
   * @param files finds a file named in the configuration
   * @param saves whether files named in the configuration are written
   * @param isFirst whether the run begins: not after a restart or swap
   */
  ChosenModellers(
      Configurator configuration, Function<String, Path> files, boolean saves, boolean isFirst) {
    all.put(REACTIVE, new ReactiveModeller(configuration));
    all.put(OBJECTS, new ObjectMapModeller(configuration));
    GridModeller grid = new GridModeller(configuration);
    all.put(GRID, grid);
    all.put(SCAN_MAP, new ScanMapModeller(configuration, grid, files, saves, isFirst));
    all.put(LANDMARKS, new LandmarkModeller(configuration));
    all.put(EGOCENTRIC, new EgocentricModeller(configuration));
    all.put(BEARINGS, new BearingModeller(configuration));
    all.put(COVERAGE, new CoverageModeller(configuration));
    for (ModellerProvider provider : ServiceLoader.load(ModellerProvider.class)) {
      all.putIfAbsent(provider.name(), provider.modeller(configuration));
    }
  }

  /**
   * Parses comma-separated names.
   *
   * @throws IllegalArgumentException naming the unknown modeller
   */
  List<String> names(String text) {
    List<String> names = new ArrayList<>();
    for (String part : text.split(",")) {
      String name = part.trim();
      if (!all.containsKey(name)) {
        throw new IllegalArgumentException(
            "MODELLERS: \""
                + name
                + "\" is not a modeller; expected some of "
                + String.join(", ", new TreeSet<>(all.keySet()))
                + " separated by commas");
      }
      if (names.contains(name)) {
        throw new IllegalArgumentException("MODELLERS: \"" + name + "\" appears twice");
      }
      names.add(name);
    }
    if (names.stream().filter(List.of(REACTIVE, EGOCENTRIC, OBJECTS)::contains).count() > 1) {
      throw new IllegalArgumentException(
          "MODELLERS: REACTIVE, EGOCENTRIC and OBJECTS would publish the same objects; expected "
              + "only one of them");
    }
    if (names.contains(GRID) && names.contains(SCAN_MAP)) {
      throw new IllegalArgumentException(
          "MODELLERS: GRID and SCAN MAP would both publish the grid; expected one");
    }
    return names;
  }

  /** Whether one of them measures the vehicle's state. */
  static boolean measureState(Collection<String> names) {
    return names.contains(SCAN_MAP) || names.contains(LANDMARKS);
  }

  /**
   * Activates exactly these modellers. New modellers adopt the knowledge of deactivated ones.
   *
   * @return the newly activated modellers
   */
  Collection<Modeller> choose(List<String> names, MapFrame frame, Sighting now) {
    HandOver left = new HandOver(ChosenModellers.class.getName());
    chosen.forEach(
        (name, modeller) -> {
          if (!names.contains(name)) {
            modeller.handOver(left, now);
          }
        });
    Map<String, Modeller> next = new LinkedHashMap<>();
    List<Modeller> begun = new ArrayList<>();
    for (String name : names) {
      Modeller modeller = all.get(name);
      next.put(name, modeller);
      if (!chosen.containsKey(name)) {
        begun.add(modeller);
        modeller.enter(frame, now);
        modeller.takeOver(left, now);
      }
    }
    chosen = next;
    return begun;
  }

  /** Active modellers by name, in the order of MODELLERS. */
  Map<String, Modeller> working() {
    return chosen;
  }
}
