package org.u2sa.sim.ground;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.world.Surface;

/**
 * Scripted faults and disturbances of a run, by time and place. Immutable; times are simulated
 * seconds since the start, positions are on the local plane.
 */
public final class Hazards {
  private static final Hazards NONE = new Hazards(List.of());

  private final List<DrivingHazard> all;

  private Hazards(List<DrivingHazard> all) {
    this.all = List.copyOf(all);
  }

  /** No hazards. */
  public static Hazards none() {
    return NONE;
  }

  /** Copy with one more hazard. */
  public Hazards with(DrivingHazard hazard) {
    List<DrivingHazard> more = new ArrayList<>(all);
    more.add(Objects.requireNonNull(hazard, "hazard"));
    return new Hazards(more);
  }

  /**
   * Random hazards, reproducible per seed: GPS outages, magnetic anomalies, slippery patches and
   * pushes, about one of each per minute or per 200 m².
   *
   * @param radiusM radius around the origin within which positions are drawn at random [m]
   * @param durationS duration of the run [s]
   */
  public static Hazards random(long seed, double radiusM, double durationS) {
    Arguments.requirePositive("radius of the hazards", radiusM);
    Arguments.requirePositive("duration of the hazards", durationS);
    Random random = new Random(seed);
    List<DrivingHazard> all = new ArrayList<>();
    for (int minute = 0; minute < durationS / 60.0; minute++) {
      double outage = 60.0 * (minute + random.nextDouble());
      all.add(new DrivingHazard.GpsOutage(outage, outage + 1.0 + 4.0 * random.nextDouble()));
      double push = 60.0 * (minute + random.nextDouble());
      double force = 40.0 * random.nextDouble();
      double turn = 20.0 * random.nextDouble() - 10.0;
      all.add(new DrivingHazard.Push(push, push + 0.5, force, -force, turn));
    }
    for (double area = 0.0; area < 4.0 * radiusM * radiusM; area += 200.0) {
      double east = radiusM * (2.0 * random.nextDouble() - 1.0);
      double north = radiusM * (2.0 * random.nextDouble() - 1.0);
      double size = 0.5 + 1.5 * random.nextDouble();
      if (random.nextBoolean()) {
        all.add(new DrivingHazard.Slippery(east, north, size, 0.05 + 0.2 * random.nextDouble()));
      } else {
        double field = 20.0 * random.nextDouble() - 10.0;
        all.add(new DrivingHazard.Magnetic(east, north, size, field, -field));
      }
    }
    return new Hazards(all);
  }

  /** All hazards in insertion order. */
  public List<DrivingHazard> all() {
    return all;
  }

  <T extends DrivingHazard> List<T> of(Class<T> kind) {
    return all.stream().filter(kind::isInstance).map(kind::cast).toList();
  }

  /** The ground with its slippery patches; where patches overlap, the lowest friction applies. */
  Surface on(Surface ground) {
    List<DrivingHazard.Slippery> patches = of(DrivingHazard.Slippery.class);
    if (patches.isEmpty()) {
      return ground;
    }
    return new Surface() {
      @Override
      public double grip(double eastM, double northM) {
        double grip = ground.grip(eastM, northM);
        for (DrivingHazard.Slippery patch : patches) {
          if (patch.covers(eastM, northM)) {
            grip = Math.min(grip, patch.grip());
          }
        }
        return grip;
      }

      @Override
      public double rollingResistance(double eastM, double northM) {
        return ground.rollingResistance(eastM, northM);
      }
    };
  }
}
