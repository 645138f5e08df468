package org.u2sa.sim.ground;

import java.util.Objects;
import org.u2sa.sim.motion.Arguments;

/** A fault or disturbance, in a time window or at a position. */
public sealed interface DrivingHazard {
  /** A hazard active from one time until just before another [s]. */
  sealed interface Window extends DrivingHazard {
    /** Start time [s]. */
    double fromS();

    /** End time, exclusive [s]. */
    double toS();

    /** Whether it is active at a time [s]. */
    default boolean lasts(double timeS) {
      return timeS >= fromS() && timeS < toS();
    }
  }

  /** GNSS outage from {@code fromS} until just before {@code toS}. */
  record GpsOutage(double fromS, double toS) implements Window {
    /** Checks that it ends after it begins. */
    public GpsOutage {
      window("GPS outage", fromS, toS);
    }
  }

  /** GNSS multipath: positions are offset by this much without the receiver noticing [m]. */
  record Multipath(double fromS, double toS, double eastM, double northM) implements Window {
    /** Checks that it ends after it begins, and the error. */
    public Multipath {
      window("multipath", fromS, toS);
      Arguments.requireInside("multipath east", eastM, -1_000.0, 1_000.0);
      Arguments.requireInside("multipath north", northM, -1_000.0, 1_000.0);
    }
  }

  /**
   * Manual override: the radio transmitter's switch is on manual and its sticks drive the motors.
   */
  record Manual(double fromS, double toS, DriveCommand sticks) implements Window {
    /** Checks that it ends after it begins. */
    public Manual {
      window("manual", fromS, toS);
      Objects.requireNonNull(sticks, "sticks");
    }
  }

  /** The radio transmitter is off: no pulses, and the multiplexer selects the receiver. */
  record RadioSilence(double fromS, double toS) implements Window {
    /** Checks that it ends after it begins. */
    public RadioSilence {
      window("radio silence", fromS, toS);
    }
  }

  /** Sets the battery to this charge at this time, 0…1. */
  record BatteryAt(double atS, double charge) implements DrivingHazard {
    /** Checks both. */
    public BatteryAt {
      Arguments.requireInside("time of the battery's charge", atS, 0.0, 1e9);
      Arguments.requireInside("charge", charge, 0.0, 1.0);
    }
  }

  /** An external force [N] and moment [N m, clockwise]. */
  record Push(double fromS, double toS, double eastN, double northN, double turnNm)
      implements Window {
    /** Checks that it ends after it begins, and the forces. */
    public Push {
      window("push", fromS, toS);
      Arguments.requireFinite("push east", eastN);
      Arguments.requireFinite("push north", northN);
      Arguments.requireFinite("push turn", turnNm);
    }
  }

  /** A circular patch of mud or ice with its own friction coefficient. */
  record Slippery(double eastM, double northM, double radiusM, double grip)
      implements DrivingHazard {
    /** Checks radius and grip. */
    public Slippery {
      Arguments.requirePositive("radius of the patch", radiusM);
      Arguments.requireInside("grip", grip, 0.01, 2.0);
    }

    boolean covers(double east, double north) {
      double toEast = east - eastM;
      double toNorth = north - northM;
      return toEast * toEast + toNorth * toNorth <= radiusM * radiusM;
    }
  }

  /**
   * A magnetic anomaly (iron or a cable). The disturbance is this field at the centre [µT] and half
   * of it at the radius; farther out it falls with the cube of the distance, as for a dipole.
   */
  record Magnetic(double eastM, double northM, double radiusM, double eastUt, double northUt)
      implements DrivingHazard {
    /** Checks radius and field. */
    public Magnetic {
      Arguments.requirePositive("radius of the magnetic place", radiusM);
      Arguments.requireInside("magnetic field east", eastUt, -1_000.0, 1_000.0);
      Arguments.requireInside("magnetic field north", northUt, -1_000.0, 1_000.0);
    }

    /** Fraction of the field at a position, 0…1. */
    double share(double east, double north) {
      double toEast = east - eastM;
      double toNorth = north - northM;
      double ratio = StrictMath.sqrt(toEast * toEast + toNorth * toNorth) / radiusM;
      return 1.0 / (1.0 + ratio * ratio * ratio);
    }
  }

  private static void window(String name, double fromS, double toS) {
    if (!(fromS >= 0.0 && toS > fromS)) {
      throw new IllegalArgumentException(
          name + ": from " + fromS + " s to " + toS + " s: expected 0 ≤ from < to");
    }
  }
}
