package org.u2sa.drivers.compass;

import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ParsedLink;
import org.u2sa.interfaces.time.Clock;

/** A compass at the other end of a link. */
public final class LinkedCompass implements Compass {
  private static final long ANSWERS_WITHIN_MICROS = Clock.micros(0.25);

  private final ByteLink link;
  private final CompassParser parser;
  private final ParsedLink parsed;
  private final byte[] request; // empty: it speaks by itself
  private Optional<Heading> answered = Optional.empty(); // when it was asked last
  private long askedMicros;
  private boolean isAsked;

  private LinkedCompass(ByteLink link, CompassParser parser, byte[] request) {
    this.link = link;
    this.parser = parser;
    this.request = request;
    parsed = new ParsedLink(link, parser);
  }

  /** One that speaks by itself. Closes the link with itself. */
  public static LinkedCompass listening(ByteLink link, CompassParser parser) {
    return new LinkedCompass(link, parser, new byte[0]);
  }

  /**
   * Sparton's SP3004D and its successors, which are asked for each heading. Closes the link with
   * itself.
   */
  public static LinkedCompass sparton(ByteLink link) {
    return new LinkedCompass(link, new SpartonCompass(), SpartonCompass.request());
  }

  @Override
  public Reading read(long nowMicros) {
    if (parsed.read(nowMicros)) {
      isAsked = false;
    }
    if (request.length > 0) {
      ask(nowMicros);
    }
    return new Reading(link.isConnected(), parser.latest());
  }

  /** One question at a time; one that is not answered is asked again. */
  private void ask(long nowMicros) {
    boolean isAnswered = parser.latest() != answered;
    boolean isOverdue = nowMicros - askedMicros > ANSWERS_WITHIN_MICROS;
    if ((!isAsked || isAnswered || isOverdue) && link.write(request)) {
      isAsked = true;
      askedMicros = nowMicros;
      answered = parser.latest();
    }
  }

  @Override
  public long malformed() {
    return parser.refused();
  }

  @Override
  public boolean isConnected() {
    return link.isConnected();
  }

  @Override
  public int connections() {
    return link.connections();
  }

  @Override
  public String trouble() {
    return link.trouble();
  }

  @Override
  public void close() {
    link.close();
  }
}
