package org.u2sa.drivers.compass;

import java.util.Optional;
import net.sf.marineapi.nmea.parser.DataNotAvailableException;
import net.sf.marineapi.nmea.parser.SentenceFactory;
import net.sf.marineapi.nmea.sentence.HDGSentence;
import net.sf.marineapi.nmea.sentence.HeadingSentence;
import org.u2sa.drivers.nmea.NmeaFramer;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * A compass that speaks NMEA 0183: HDG and HDM (magnetic), HDT (true). HDG's deviation is added;
 * its variation is not, since it was typed into the compass once, and the model knows better.
 */
public final class NmeaCompass implements CompassParser {
  private static final double TURN_DEG = 360.0;

  private final NmeaFramer framer = new NmeaFramer();
  private final NmeaFramer.Sink sink = this::take;
  private final SentenceFactory factory = SentenceFactory.getInstance();
  private Optional<Heading> latest = Optional.empty();
  private long nowMicros;
  private long refused;
  private String lastRefusal = "";

  @Override
  public void accept(byte[] bytes, int length, long now) {
    nowMicros = now;
    framer.accept(bytes, length, sink);
  }

  private void take(NmeaSentence sentence) {
    if (!sentence.is("HDG") && !sentence.is("HDM") && !sentence.is("HDT")) {
      return;
    }
    String text = sentence.text();
    try {
      HeadingSentence said = (HeadingSentence) factory.createParser(text);
      double headingDeg = said.getHeading();
      if (!(headingDeg >= 0.0 && headingDeg <= TURN_DEG)) {
        throw new IllegalArgumentException("heading " + headingDeg + " is outside 0…360 deg");
      }
      if (said instanceof HDGSentence hdg) {
        headingDeg += deviationDeg(hdg);
      }
      latest = Optional.of(Heading.ofDegrees(nowMicros, headingDeg, said.isTrue()));
    } catch (DataNotAvailableException e) {
      refuse("no heading: " + text); // as some say while they are being calibrated
    } catch (RuntimeException e) { // marineapi throws several for what it cannot understand
      refuse(e.getMessage() + ": " + text);
    }
  }

  /** East positive. */
  private static double deviationDeg(HDGSentence hdg) {
    try {
      return hdg.getDeviation();
    } catch (DataNotAvailableException e) {
      return 0.0;
    }
  }

  private void refuse(String why) {
    refused++;
    lastRefusal = why;
  }

  @Override
  public Optional<Heading> latest() {
    return latest;
  }

  @Override
  public void reset() {
    framer.reset();
  }

  @Override
  public long refused() {
    return framer.refused() + refused;
  }

  @Override
  public String lastRefusal() {
    return lastRefusal.isEmpty() ? framer.lastRefusal() : lastRefusal;
  }
}
