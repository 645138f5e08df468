package org.u2sa.drivers.compass;

import java.util.Optional;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.interfaces.time.Clock;

/** A compass on a link. */
public final class LinkedCompass extends ParsedDevice<Heading> implements Compass {
  private static final long ANSWERS_WITHIN_MICROS = Clock.micros(0.25);

  private final byte[] request; // empty if the compass streams
  private Optional<Heading> answered = Optional.empty(); // heading before the last request
  private long askedMicros;
  private boolean isAsked;

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

  /** Sends one request at a time, and repeats it if unanswered. */
  @Override
  protected void act(long nowMicros) {
    boolean isAnswered = latest != answered;
    boolean isOverdue = nowMicros - askedMicros > ANSWERS_WITHIN_MICROS;
    if (request.length > 0 && (!isAsked || isAnswered || isOverdue) && link.write(request)) {
      isAsked = true;
      askedMicros = nowMicros;
      answered = latest;
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
