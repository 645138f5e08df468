package org.u2sa.drivers.compass;

import java.util.Optional;
import org.u2sa.device.Compass;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.Heading;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceContext;

/** A compass at the other end of a link. */
public final class LinkedCompass extends ParsedDevice<Heading> implements Compass {
  private static final long ANSWERS_WITHIN_MICROS = Clock.micros(0.25);

  private final byte[] request; // empty: it speaks by itself
  private Optional<Heading> answered = Optional.empty(); // when it was asked last
  private long askedMicros;
  private boolean isAsked;

  private LinkedCompass(ByteLink link, ByteParser<Heading> parser, byte[] request) {
    super(link, parser);
    this.request = request;
  }

  /** One that speaks NMEA 0183 by itself. Closes the link with itself. */
  public static LinkedCompass nmea(ByteLink link) {
    return new LinkedCompass(link, NmeaCompass.parser(), new byte[0]);
  }

  /**
   * Sparton's SP3004D and its successors, which are asked for each heading. Closes the link with
   * itself.
   */
  public static LinkedCompass sparton(ByteLink link) {
    return new LinkedCompass(link, new SpartonCompass(), SpartonCompass.request());
  }

  @Override
  protected void found(long nowMicros) {
    super.found(nowMicros);
    isAsked = false;
  }

  /** One question at a time; one that is not answered is asked again. */
  @Override
  protected void act(long nowMicros) {
    boolean isAnswered = latest() != answered;
    boolean isOverdue = nowMicros - askedMicros > ANSWERS_WITHIN_MICROS;
    if (request.length > 0 && (!isAsked || isAnswered || isOverdue) && link.write(request)) {
      isAsked = true;
      askedMicros = nowMicros;
      answered = latest();
    }
  }

  /** COMPASS NMEA and SPARTON in a configuration. */
  public static final class Provider extends DeviceProvider<Compass> {
    /** For {@link java.util.ServiceLoader}. */
    public Provider() {
      super(Compass.class, "NMEA", "SPARTON");
    }

    @Override
    protected Compass open(String name, ServiceContext context) {
      ByteLink link = ByteLinks.of(context);
      return name.equals("NMEA") ? nmea(link) : sparton(link);
    }
  }
}
