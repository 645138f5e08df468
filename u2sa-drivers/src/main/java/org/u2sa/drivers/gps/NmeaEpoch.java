package org.u2sa.drivers.gps;

/** Fields accumulated for one epoch; unset numbers are NaN. */
final class NmeaEpoch {
  /** Sentences with time and position. */
  enum Kind {
    RMC,
    GGA
  }

  final long timeMs; // receiver's time of day, or NmeaReader.NO_TIME
  final long heardMicros; // arrival of the first sentence
  boolean hasRmc;
  boolean hasGga;
  Kind last;
  boolean valid;
  double latitudeDeg = Double.NaN;
  double longitudeDeg = Double.NaN;
  double altitudeM = Double.NaN;
  double speedMps = Double.NaN;
  double courseRad = Double.NaN;
  double dilution = Double.NaN;
  FixQuality quality = FixQuality.PLAIN;
  int satellites;

  NmeaEpoch(Kind kind, long timeMs, long heardMicros) {
    this.timeMs = timeMs;
    this.heardMicros = heardMicros;
    last = kind;
    hasRmc = kind == Kind.RMC;
    hasGga = kind == Kind.GGA;
  }

  /** Whether the epochs differ. */
  boolean isBefore(NmeaEpoch next) {
    return next.timeMs != timeMs || next.hasRmc && hasRmc || next.hasGga && hasGga;
  }

  /** Merges another sentence of this epoch. */
  void add(NmeaEpoch other) {
    valid &= other.valid;
    hasRmc |= other.hasRmc;
    hasGga |= other.hasGga;
    last = other.last;
    if (other.hasGga || Double.isNaN(latitudeDeg)) { // GGA often has more decimals
      quality = other.quality; // GGA distinguishes RTK in every NMEA 0183 version
      latitudeDeg = other.latitudeDeg;
      longitudeDeg = other.longitudeDeg;
    }
    altitudeM = either(altitudeM, other.altitudeM);
    speedMps = either(speedMps, other.speedMps);
    courseRad = either(courseRad, other.courseRad);
    dilution = either(dilution, other.dilution);
    satellites = Math.max(satellites, other.satellites);
  }

  private static double either(double one, double other) {
    return Double.isNaN(one) ? other : one;
  }
}
