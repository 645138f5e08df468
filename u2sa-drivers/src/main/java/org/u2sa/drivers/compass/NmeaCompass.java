package org.u2sa.drivers.compass;

import java.util.Optional;
import net.sf.marineapi.nmea.parser.DataNotAvailableException;
import net.sf.marineapi.nmea.parser.SentenceFactory;
import net.sf.marineapi.nmea.sentence.HDGSentence;
import net.sf.marineapi.nmea.sentence.HeadingSentence;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * Parser of NMEA 0183 compasses: HDG and HDM (magnetic), HDT (true). HDG's deviation is applied;
 * its variation is not, because it was entered manually and the geomagnetic model is more accurate.
 */
public final class NmeaCompass {
  private static final double TURN_DEG = 360.0;
  private static final double HALF_TURN_DEG = 180.0;

  private final SentenceFactory factory = SentenceFactory.getInstance();

  private NmeaCompass() {}

  /** Converts bytes to headings. */
  public static NmeaParser<Heading> parser() {
    return new NmeaParser<>(meaning());
  }

  /** Converts sentences to headings. */
  static NmeaParser.Meaning<Heading> meaning() {
    return new NmeaCompass()::heading;
  }

  private Optional<Heading> heading(NmeaSentence sentence, long nowMicros) {
    if (!sentence.is("HDG") && !sentence.is("HDM") && !sentence.is("HDT")) {
      return Optional.empty();
    }
    try {
      HeadingSentence said = (HeadingSentence) factory.createParser(sentence.text());
      double headingDeg = said.getHeading();
      if (!(headingDeg >= 0.0 && headingDeg <= TURN_DEG)) {
        throw new IllegalArgumentException("heading " + headingDeg + " is outside 0…360 deg");
      }
      if (said instanceof HDGSentence hdg) {
        headingDeg += deviationDeg(hdg);
      }
      return Optional.of(Heading.ofDegrees(nowMicros, headingDeg, said.isTrue()));
    } catch (DataNotAvailableException e) { // sent by some compasses during calibration
      throw new IllegalArgumentException("no heading", e);
    }
  }

  /** Deviation, east positive. */
  private static double deviationDeg(HDGSentence hdg) {
    try {
      double deviationDeg = hdg.getDeviation();
      if (!(Math.abs(deviationDeg) <= HALF_TURN_DEG)) { // marineapi parses "NaN" as a number
        throw new IllegalArgumentException(
            "deviation " + deviationDeg + " is outside -180…180 deg");
      }
      return deviationDeg;
    } catch (DataNotAvailableException e) {
      return 0.0;
    }
  }
}
