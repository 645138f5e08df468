package org.u2sa.scenarios.igvc;

import java.util.Random;
import java.util.Set;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.ground.DrivingHazard;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.sensor.NoiseStreams;

/** Kinds of adverse conditions in a run; places and times depend on the seed. */
enum Hardness {
  /** GNSS multipath, for some seconds in most minutes. */
  MULTIPATH {
    @Override
    Hazards with(Hazards hazards, Course course, Random random) {
      Hazards more = hazards;
      for (int k = 0; k < Judge.RUN_S / MULTIPATH_EVERY_S; k++) {
        double fromS = MULTIPATH_EVERY_S * (k + random.nextDouble());
        double toS = fromS + 3.0 + 7.0 * random.nextDouble();
        double offM = 0.5 + random.nextDouble();
        double angle = 2.0 * Math.PI * random.nextDouble();
        more =
            more.with(
                new DrivingHazard.Multipath(
                    fromS, toS, offM * StrictMath.sin(angle), offM * StrictMath.cos(angle)));
      }
      return more;
    }
  },

  /** The laser loses echoes, and at edges measures ranges between foreground and background. */
  MIXED_PIXELS,

  /** Patches of mud where wheels slip. */
  SLIP {
    @Override
    Hazards with(Hazards hazards, Course course, Random random) {
      Hazards more = hazards;
      for (int k = 0; k < PATCHES; k++) {
        Place at = Place.on(course, random);
        double radiusM = 0.5 + random.nextDouble();
        double grip = 0.15 + 0.15 * random.nextDouble();
        more = more.with(new DrivingHazard.Slippery(at.eastM, at.northM, radiusM, grip));
      }
      return more;
    }
  },

  /** Cables and iron in the ground that disturb the compass by about ten degrees. */
  COMPASS {
    @Override
    Hazards with(Hazards hazards, Course course, Random random) {
      Hazards more = hazards;
      for (int k = 0; k < PATCHES; k++) {
        Place at = Place.on(course, random);
        double eastUt = 10.0 * random.nextDouble() - 5.0;
        double northUt = 10.0 * random.nextDouble() - 5.0;
        more = more.with(new DrivingHazard.Magnetic(at.eastM, at.northM, 1.0, eastUt, northUt));
      }
      return more;
    }
  };

  private static final double MULTIPATH_EVERY_S = 45.0;
  private static final int PATCHES = 12;
  private static final double AROUND_M = 20.0;
  private static final SimulatedLaser.Faults FAULTS = new SimulatedLaser.Faults(0.02, 0.3);

  /** Random place near one of the course's waypoints. */
  private record Place(double eastM, double northM) {
    static Place on(Course course, Random random) {
      Course.Goal goal = course.goals().get(random.nextInt(course.goals().size()));
      return new Place(
          goal.eastM() + AROUND_M * (random.nextDouble() - 0.5),
          goal.northM() + AROUND_M * (random.nextDouble() - 0.5));
    }
  }

  /** Adds hazards of this kind to the given ones. */
  Hazards with(Hazards hazards, Course course, Random random) {
    return hazards;
  }

  /** All hazards of the chosen kinds; each kind uses a separate random stream. */
  static Hazards hazards(Set<Hardness> chosen, Course course, NoiseStreams streams) {
    Hazards hazards = Hazards.none();
    for (Hardness each : values()) {
      if (chosen.contains(each)) {
        hazards = each.with(hazards, course, streams.of("hardness " + each));
      }
    }
    return hazards;
  }

  static SimulatedLaser.Faults laser(Set<Hardness> chosen) {
    return chosen.contains(MIXED_PIXELS) ? FAULTS : SimulatedLaser.Faults.NONE;
  }
}
