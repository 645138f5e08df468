package org.u2sa.drivers.gps;

import java.util.OptionalDouble;
import org.u2sa.device.port.GpsFix;

/**
 * Messages accumulated for one time of week: NAV-POSLLH, NAV-VELNED, and NAV-SOL or NAV-STATUS. A
 * new time of week starts a new epoch; an incomplete one is dropped.
 */
final class UbxEpoch {
  private static final long NONE = -1;
  private static final int FIX_2D = 2;
  private static final int FIX_3D = 3;
  private static final int FIX_WITH_DEAD_RECKONING = 4;
  private static final int FIX_OK = 1; // flag

  private long timeOfWeekMs = NONE;
  private long heardMicros;
  private boolean hasPosition;
  private boolean hasVelocity;
  private boolean hasStatus;
  private double latitudeDeg;
  private double longitudeDeg;
  private double altitudeM;
  private double horizontalSigmaM;
  private double verticalSigmaM;
  private double eastMps;
  private double northMps;
  private double upMps;
  private int fixType;
  private int flags;
  private int satellites;

  /** Selects the epoch of a message. */
  UbxEpoch at(long newTimeOfWeekMs, long nowMicros) {
    if (newTimeOfWeekMs != timeOfWeekMs) {
      clear();
      timeOfWeekMs = newTimeOfWeekMs;
      heardMicros = nowMicros;
    }
    return this;
  }

  void position(
      double newLatitudeDeg,
      double newLongitudeDeg,
      double newAltitudeM,
      double newHorizontalSigmaM,
      double newVerticalSigmaM) {
    hasPosition = true;
    latitudeDeg = newLatitudeDeg;
    longitudeDeg = newLongitudeDeg;
    altitudeM = newAltitudeM;
    horizontalSigmaM = newHorizontalSigmaM;
    verticalSigmaM = newVerticalSigmaM;
  }

  void velocity(double newEastMps, double newNorthMps, double newUpMps) {
    hasVelocity = true;
    eastMps = newEastMps;
    northMps = newNorthMps;
    upMps = newUpMps;
  }

  void status(int newFixType, int newFlags, int newSatellites) {
    hasStatus = true;
    fixType = newFixType;
    flags = newFlags;
    satellites = Math.max(satellites, newSatellites);
  }

  boolean isWhole() {
    return hasPosition && hasVelocity && hasStatus;
  }

  /** Returns the fix once. */
  GpsFix take() {
    hasPosition = false; // a duplicate message must not produce a second fix
    boolean isValid =
        (flags & FIX_OK) != 0 && fixType >= FIX_2D && fixType <= FIX_WITH_DEAD_RECKONING;
    return isValid ? fix() : GpsFix.none(heardMicros, satellites);
  }

  private GpsFix fix() {
    return new GpsFix(
        heardMicros,
        Plausible.latitudeDeg(latitudeDeg),
        Plausible.longitudeDeg(longitudeDeg),
        vertical(Plausible.altitudeM(altitudeM)),
        OptionalDouble.of(Plausible.velocityMps(eastMps)),
        OptionalDouble.of(Plausible.velocityMps(northMps)),
        vertical(Plausible.velocityMps(upMps)),
        OptionalDouble.of(horizontalSigmaM),
        vertical(verticalSigmaM),
        satellites,
        true);
  }

  /** A value that depends on height, which is valid only in a 3-D fix. */
  private OptionalDouble vertical(double value) {
    return fixType >= FIX_3D ? OptionalDouble.of(value) : OptionalDouble.empty();
  }

  void clear() {
    timeOfWeekMs = NONE;
    hasPosition = false;
    hasVelocity = false;
    hasStatus = false;
    satellites = 0;
  }
}
