package org.u2sa.drivers.compass;

import java.util.Optional;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.interfaces.time.Clock;

/**
 * A compass on a link.
 *
 * <p>A polled compass answers with its newest heading, however often it is asked, and measures at
 * least 20 times a second. So an answer equal to the previous one is no measurement within that
 * time. Nor is an answer that was read after a pause, because it may have waited as long; the next
 * one is used in any case.
 */
public final class LinkedCompass extends ParsedDevice<Heading> implements Compass {
  private static final long ANSWERS_WITHIN_MICROS = Clock.micros(0.25);

  private static final long MEASURES_WITHIN_MICROS = Clock.micros(0.05);

  private final byte[] request; // empty if the compass streams
  private long askedMicros;
  private boolean isAsked;
  private boolean isAnswered;
  private long readMicros = Long.MIN_VALUE; // time of the last read
  private boolean hasPaused; // before the current read
  private boolean isDropped; // the last answer, which had waited

  private LinkedCompass(ByteLink link, ByteParser<Heading> parser, byte[] request) {
    super(link, parser);
    this.request = request;
  }

  /** Creates a compass that streams NMEA 0183. Closing the device closes the link. */
  public static LinkedCompass nmea(ByteLink link) {
    return new LinkedCompass(link, NmeaCompass.parser(), new byte[0]);
  }

  /**
   * Creates a Sparton SP3004D or successor, which is polled for each heading. Closing the device
   * closes the link.
   */
  public static LinkedCompass sparton(ByteLink link) {
    return new LinkedCompass(link, new SpartonCompass(), SpartonCompass.request());
  }

  @Override
  protected void found(long nowMicros) {
    super.found(nowMicros);
    isAsked = false;
  }

  @Override
  public Optional<Heading> read(long nowMicros) {
    hasPaused = readMicros != Long.MIN_VALUE && nowMicros - readMicros > MEASURES_WITHIN_MICROS;
    readMicros = nowMicros;
    return super.read(nowMicros);
  }

  @Override
  protected boolean isNews(Heading heading) {
    if (request.length == 0) {
      return true;
    }
    isAnswered = true;
    isDropped = hasPaused && !isDropped;
    return !isDropped && latest.map(before -> isNewer(heading, before)).orElse(true);
  }

  private static boolean isNewer(Heading heading, Heading before) {
    return heading.headingRad() != before.headingRad()
        || heading.isTrue() != before.isTrue()
        || heading.measuredAtMicros() - before.measuredAtMicros() >= MEASURES_WITHIN_MICROS;
  }

  /** Sends one request at a time, and repeats it if unanswered. */
  @Override
  protected void act(long nowMicros) {
    boolean isOverdue = nowMicros - askedMicros > ANSWERS_WITHIN_MICROS;
    if (request.length > 0 && (!isAsked || isAnswered || isOverdue) && link.write(request)) {
      isAsked = true;
      askedMicros = nowMicros;
      isAnswered = false;
    }
  }

  /** Provider of COMPASS = NMEA and SPARTON. */
  public static final class Provider extends LinkProvider<Compass> {
    public Provider() {
      super(
          Compass.class,
          (name, link) -> name.equals("NMEA") ? nmea(link) : sparton(link),
          "NMEA",
          "SPARTON");
    }
  }
}
