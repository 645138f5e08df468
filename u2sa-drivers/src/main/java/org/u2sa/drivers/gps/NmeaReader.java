package org.u2sa.drivers.gps;

import java.util.Optional;
import java.util.function.DoubleSupplier;
import net.sf.marineapi.nmea.parser.DataNotAvailableException;
import net.sf.marineapi.nmea.parser.SentenceFactory;
import net.sf.marineapi.nmea.sentence.GGASentence;
import net.sf.marineapi.nmea.sentence.GSASentence;
import net.sf.marineapi.nmea.sentence.GSTSentence;
import net.sf.marineapi.nmea.sentence.RMCSentence;
import net.sf.marineapi.nmea.sentence.TimeSentence;
import net.sf.marineapi.nmea.sentence.VTGSentence;
import net.sf.marineapi.nmea.util.DataStatus;
import net.sf.marineapi.nmea.util.Position;
import net.sf.marineapi.nmea.util.Time;
import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * Parses a receiver's sentences into SI units; the only class that uses marineapi. Malformed and
 * out-of-range values are rejected and counted.
 */
final class NmeaReader implements NmeaParser.Meaning<GpsFix> {
  /** Absent time. */
  static final long NO_TIME = -1;

  private static final double MPS_PER_KNOT = 1852.0 / 3600.0;
  private static final double FASTEST_MPS = 1_000.0;
  private static final double WORST_DILUTION = 50.0; // receivers use 99.99 for "none"
  private static final double WORST_SIGMA_M = 10_000.0;
  private static final long MS_PER_S = 1_000;
  private static final int SECONDS_PER_MINUTE = 60;
  private static final int MINUTES_PER_HOUR = 60;

  private final SentenceFactory factory = SentenceFactory.getInstance();
  private final NmeaEpochs epochs;

  NmeaReader(NmeaEpochs epochs) {
    this.epochs = epochs;
  }

  /** Passes the sentence to the epochs, which hold the fix; ignores other types. */
  @Override
  public Optional<GpsFix> of(NmeaSentence sentence, long nowMicros) {
    boolean known =
        sentence.is("RMC")
            || sentence.is("GGA")
            || sentence.is("GST")
            || sentence.is("GSA")
            || sentence.is("VTG");
    if (known) {
      take(factory.createParser(sentence.text()), nowMicros);
    }
    return Optional.empty();
  }

  private void take(Object sentence, long nowMicros) {
    if (sentence instanceof RMCSentence rmc) {
      take(rmc, nowMicros);
    } else if (sentence instanceof GGASentence gga) {
      take(gga, nowMicros);
    } else if (sentence instanceof GSTSentence gst) {
      epochs.sigmas(
          Math.sqrt(
              (square(sigma(gst::getLatitudeError)) + square(sigma(gst::getLongitudeError))) / 2.0),
          sigma(gst::getAltitudeError));
    } else if (sentence instanceof GSASentence gsa) {
      epochs.dilution(dilution(gsa::getHorizontalDOP), dilution(gsa::getVerticalDOP));
    } else if (sentence instanceof VTGSentence vtg) {
      epochs.velocity(speed(vtg::getSpeedKnots), course(vtg::getTrueCourse));
    }
  }

  private void take(RMCSentence rmc, long nowMicros) {
    NmeaEpoch said = new NmeaEpoch(NmeaEpoch.Kind.RMC, time(rmc), nowMicros);
    Optional<FixQuality> quality = quality(rmc);
    said.valid = rmc.getStatus() == DataStatus.ACTIVE && quality.isPresent();
    if (said.valid) {
      said.quality = quality.orElseThrow();
      position(said, rmc.getPosition());
      said.speedMps = speed(rmc::getSpeed);
      said.courseRad = course(rmc::getCourse);
    }
    epochs.take(said);
  }

  /**
   * Fix quality by mode; empty if the position is not measured. The mode was added in NMEA 2.3;
   * older receivers omit it.
   */
  private static Optional<FixQuality> quality(RMCSentence rmc) {
    try {
      return switch (rmc.getMode()) {
        case NONE, ESTIMATED, MANUAL, SIMULATED -> Optional.empty();
        case DGPS -> Optional.of(FixQuality.DIFFERENTIAL);
        case RTK_FLOAT -> Optional.of(FixQuality.RTK_FLOAT);
        case RTK_FIXED -> Optional.of(FixQuality.RTK_FIXED);
        default -> Optional.of(FixQuality.PLAIN);
      };
    } catch (DataNotAvailableException | IllegalArgumentException e) {
      return Optional.of(FixQuality.PLAIN);
    }
  }

  /**
   * Fix quality; empty if the position is not measured: none, dead reckoning, manual, simulated.
   */
  private static Optional<FixQuality> quality(GGASentence gga) {
    return switch (gga.getFixQuality()) {
      case INVALID, ESTIMATED, MANUAL, SIMULATED -> Optional.empty();
      case DGPS -> Optional.of(FixQuality.DIFFERENTIAL);
      case RTK -> Optional.of(FixQuality.RTK_FIXED);
      case FRTK -> Optional.of(FixQuality.RTK_FLOAT);
      default -> // autonomous, or PPS, for which no receiver figure is published
          Optional.of(FixQuality.PLAIN);
    };
  }

  private void take(GGASentence gga, long nowMicros) {
    NmeaEpoch said = new NmeaEpoch(NmeaEpoch.Kind.GGA, time(gga), nowMicros);
    Optional<FixQuality> quality = quality(gga);
    said.valid = quality.isPresent();
    if (said.valid) {
      said.quality = quality.orElseThrow();
      position(said, gga.getPosition());
      said.altitudeM = Plausible.altitudeM(number(gga::getAltitude)); // above mean sea level
      said.dilution = dilution(gga::getHorizontalDOP);
    }
    double satellites = number(gga::getSatelliteCount);
    said.satellites = Double.isNaN(satellites) ? 0 : Math.max(0, (int) satellites);
    epochs.take(said);
  }

  private static void position(NmeaEpoch said, Position position) {
    said.latitudeDeg = present(Plausible.latitudeDeg(position.getLatitude()));
    said.longitudeDeg = present(Plausible.longitudeDeg(position.getLongitude()));
  }

  private static double present(double value) {
    if (Double.isNaN(value)) {
      throw new IllegalArgumentException("no position in a sentence marked valid");
    }
    return value;
  }

  /** Time of day [ms], or {@link #NO_TIME}. */
  private static long time(TimeSentence sentence) {
    try {
      Time time = sentence.getTime();
      int minutes = time.getHour() * MINUTES_PER_HOUR + time.getMinutes();
      return Math.round((minutes * (double) SECONDS_PER_MINUTE + time.getSeconds()) * MS_PER_S);
    } catch (DataNotAvailableException e) {
      return NO_TIME;
    }
  }

  private static double speed(DoubleSupplier knots) {
    return Plausible.inRange("speed", MPS_PER_KNOT * number(knots), 0.0, FASTEST_MPS);
  }

  private static double course(DoubleSupplier degrees) {
    return Math.toRadians(Plausible.inRange("course", number(degrees), 0.0, 360.0));
  }

  private static double sigma(DoubleSupplier metres) {
    return Plausible.inRange("standard deviation", number(metres), 0.0, WORST_SIGMA_M);
  }

  private static double dilution(DoubleSupplier dilution) {
    double value = number(dilution);
    return value > 0.0 && value < WORST_DILUTION ? value : Double.NaN;
  }

  /** Numeric value of a field; NaN if empty. */
  private static double number(DoubleSupplier field) {
    try {
      return field.getAsDouble();
    } catch (DataNotAvailableException e) {
      return Double.NaN;
    }
  }

  private static double square(double value) {
    return value * value;
  }
}
