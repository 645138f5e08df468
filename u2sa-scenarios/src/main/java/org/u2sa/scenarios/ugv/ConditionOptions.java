package org.u2sa.scenarios.ugv;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.score.RunPlan;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Mixin with options for vehicle, load and ground. */
final class ConditionOptions {
  /** Type of ground. */
  enum GroundKind {
    /** Trodden earth and short grass. */
    LAWN(Surface.lawn()),
    /** Dry concrete. */
    CONCRETE(Surface.concrete()),
    /** Wet and soft. */
    FIELD(Surface.field());

    private final Surface surface;

    GroundKind(Surface surface) {
      this.surface = surface;
    }
  }

  private static final double FULL_PERCENT = 100.0;
  private static final double HILL_OF_MISSION = 1.5; // hill radius / mission radius
  private static final double SMALLEST_HILL_M = 5.0;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(
      names = "--mismatch",
      paramLabel = "PERCENT",
      description =
          "Mismatch of the motors: by how much the right one is stronger and the left one weaker "
              + "than commanded, -50 to 50. Default: drawn from the seed, within ±5.")
  private Double mismatch;

  @Option(
      names = "--payload",
      paramLabel = "KG",
      description = "Payload above the centre of gravity. Default: 0.")
  private double payloadKg;

  @Option(
      names = "--surface",
      description = "One of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private GroundKind surface = GroundKind.LAWN;

  @Option(
      names = "--slope",
      paramLabel = "DEGREES",
      description = "Uniform slope that rises to the north, up to 20 degrees. Default: level.")
  private double slopeDeg;

  @Option(
      names = "--hill",
      paramLabel = "DEGREES",
      description =
          "Steepest slope of a round hill amid the waypoints, up to 20 degrees. Default: no hill.")
  private double hillDeg;

  /**
   * Validates the options.
   *
   * @throws ParameterException if options conflict or are out of range
   */
  void check(UgvDemo.VehicleKind vehicle) {
    require("--payload", payloadKg, 0.0, 500.0, "kg");
    require("--slope", slopeDeg, 0.0, 20.0, "degrees");
    require("--hill", hillDeg, 0.0, 20.0, "degrees");
    if (slopeDeg > 0.0 && hillDeg > 0.0) {
      throw wrong("--slope and --hill: expected only one of them");
    }
    if (mismatch != null) {
      require("--mismatch", mismatch, -50.0, 50.0, "percent");
      if (vehicle == UgvDemo.VehicleKind.ACKERMANN) {
        throw wrong("--mismatch: applies to two motors; expected none with --vehicle ackermann");
      }
    }
  }

  /** Overrides of values of the vehicle file, by path. */
  Map<String, String> changes(UgvDemo.VehicleKind vehicle) {
    Map<String, String> changes = new LinkedHashMap<>();
    if (mismatch != null) {
      changes.put(vehicle.dynamics() + "/exactMismatch", "" + mismatch / FULL_PERCENT);
    }
    changes.put(vehicle.dynamics() + "/payload", "" + payloadKg);
    return changes;
  }

  /**
   * The world with the ground of the options.
   *
   * @param plan determines the position of the hill
   */
  World ground(World level, RunPlan plan) {
    return level.with(terrain(plan)).with(surface.surface);
  }

  /** Deviations from the default, for reports; empty if none. */
  String words() {
    List<String> words = new ArrayList<>();
    if (mismatch != null) {
      words.add("motors " + figure(mismatch) + " % apart");
    }
    if (payloadKg > 0.0) {
      words.add("+" + figure(payloadKg) + " kg");
    }
    if (surface != GroundKind.LAWN) {
      words.add(surface.name().toLowerCase(Locale.ROOT));
    }
    if (slopeDeg > 0.0) {
      words.add("slope " + figure(slopeDeg) + " degrees");
    }
    if (hillDeg > 0.0) {
      words.add("hill " + figure(hillDeg) + " degrees");
    }
    return String.join(", ", words);
  }

  /** A number without trailing zeros. */
  private static String figure(double value) {
    return value == Math.rint(value)
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.valueOf(value);
  }

  private Terrain terrain(RunPlan plan) {
    if (slopeDeg > 0.0) {
      return Terrain.slope(Math.toRadians(slopeDeg), 0.0);
    }
    return hillDeg > 0.0 ? hill(plan) : Terrain.flat();
  }

  private Terrain hill(RunPlan plan) {
    Geodetic home = plan.home().orElseThrow().onMap();
    double north = 0.0;
    double east = 0.0;
    double farthestM = SMALLEST_HILL_M;
    for (RunPlan.Waypoint waypoint : plan.waypoints()) {
      Point from = home.nedOf(waypoint.onMap());
      north += from.x() / plan.waypoints().size();
      east += from.y() / plan.waypoints().size();
    }
    for (RunPlan.Waypoint waypoint : plan.waypoints()) {
      Point from = home.nedOf(waypoint.onMap());
      farthestM = Math.max(farthestM, Math.hypot(from.x() - north, from.y() - east));
    }
    return Terrain.hill(east, north, HILL_OF_MISSION * farthestM, Math.toRadians(hillDeg));
  }

  private void require(String option, double value, double least, double most, String unit) {
    if (!(value >= least && value <= most)) {
      String range = figure(least) + " to " + figure(most);
      throw wrong(option + " " + figure(value) + ": expected " + range + " " + unit);
    }
  }

  private ParameterException wrong(String message) {
    return new ParameterException(command.commandLine(), message);
  }
}
