package org.u2sa.drivers.gps;

import java.util.List;
import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ParsedLink;

/** A satellite receiver at the other end of a link. */
public final class LinkedGps implements GpsReceiver {
  private final ByteLink link;
  private final GpsParser parser;
  private final ParsedLink parsed;
  private final Optional<UbxSetup> setup;

  private LinkedGps(ByteLink link, GpsParser parser, Optional<UbxSetup> setup) {
    this.link = link;
    this.parser = parser;
    this.setup = setup;
    parsed = new ParsedLink(link, parser);
  }

  /** One that is only listened to. Closes the link with itself. */
  public static LinkedGps listening(ByteLink link, GpsParser parser) {
    return new LinkedGps(link, parser, Optional.empty());
  }

  /**
   * One of u-blox that is told, after each connection, what to send. Closes the link with itself.
   *
   * @param baud of its first serial port [baud]
   * @param rateHz solutions a second
   */
  public static LinkedGps ublox(ByteLink link, UbloxModel model, int baud, double rateHz) {
    UbxGps parser = new UbxGps();
    UbxSetup setup = new UbxSetup(messages(model), baud, rateHz);
    parser.answersTo(setup::answered);
    return new LinkedGps(link, parser, Optional.of(setup));
  }

  private static List<Integer> messages(UbloxModel model) {
    return model == UbloxModel.UBLOX_6
        ? List.of(UbxGps.NAV_POSLLH, UbxGps.NAV_VELNED, UbxGps.NAV_SOL)
        : List.of(UbxGps.NAV_PVT);
  }

  @Override
  public Reading read(long nowMicros) {
    boolean isNew = parsed.read(nowMicros);
    setup.ifPresent(
        told -> {
          if (isNew) {
            told.begin();
          }
          told.step(link, nowMicros);
        });
    return new Reading(link.isConnected(), parser.latest());
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
    String own = link.trouble();
    return own.isEmpty() ? setup.map(UbxSetup::trouble).orElse("") : own;
  }

  @Override
  public void close() {
    link.close();
  }
}
