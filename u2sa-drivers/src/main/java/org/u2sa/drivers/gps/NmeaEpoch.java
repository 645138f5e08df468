package org.u2sa.drivers.gps;

/** What the sentences of one moment said so far; a number that none said is NaN. */
final class NmeaEpoch {
  /** The sentences that have a time and a position. */
  enum Kind {
    RMC,
    GGA
  }

  final long timeMs; // of the day, by the receiver; NmeaReader.NO_TIME if it does not say
  final long heardMicros; // when the first of them came
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

  /** Whether the other one is of another moment. */
  boolean isBefore(NmeaEpoch next) {
    return next.timeMs != timeMs || next.hasRmc && hasRmc || next.hasGga && hasGga;
  }

  /** Adds what another sentence of the same moment said. */
  void add(NmeaEpoch other) {
    valid &= other.valid;
    hasRmc |= other.hasRmc;
    hasGga |= other.hasGga;
    last = other.last;
    if (other.hasGga || Double.isNaN(latitudeDeg)) { // some write more decimals in GGA
      quality = other.quality; // GGA tells RTK apart in every version of NMEA 0183
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
