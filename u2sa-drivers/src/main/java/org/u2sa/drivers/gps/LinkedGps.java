package org.u2sa.drivers.gps;

import java.util.Optional;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** A GNSS receiver on a link. */
public final class LinkedGps extends ParsedDevice<GpsFix> implements GpsReceiver {
  private final Optional<UbxSetup> setup;

  private LinkedGps(ByteLink link, ByteParser<GpsFix> parser, Optional<UbxSetup> setup) {
    super(link, parser);
    this.setup = setup;
  }

  /** Creates a receiver that is only read. Closing the device closes the link. */
  public static LinkedGps listening(ByteLink link, ByteParser<GpsFix> parser) {
    return new LinkedGps(link, parser, Optional.empty());
  }

  /**
   * Creates a u-blox receiver that is configured after each connection. Closing the device closes
   * the link.
   *
   * @param baud rate of its first serial port [baud]
   * @param rateHz navigation rate [Hz]
   */
  public static LinkedGps ublox(ByteLink link, UbloxModel model, int baud, double rateHz) {
    UbxGps parser = new UbxGps();
    UbxSetup setup = new UbxSetup(model.messages(), baud, rateHz);
    parser.answersTo(setup::answered);
    return new LinkedGps(link, parser, Optional.of(setup));
  }

  @Override
  protected void found(long nowMicros) {
    super.found(nowMicros);
    setup.ifPresent(UbxSetup::begin);
  }

  @Override
  protected void act(long nowMicros) {
    setup.ifPresent(told -> told.step(link, nowMicros));
  }

  @Override
  protected String ownTrouble() {
    return setup.map(UbxSetup::trouble).orElse("");
  }

  /** Provider of RECEIVER = NMEA, UBLOX 6 and UBLOX 8. */
  public static final class Provider extends LinkProvider<GpsReceiver> {
    private record Variables(
        @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = NmeaGps.USUAL_RANGE_ERROR_M)
            @Description(
                "NMEA: standard deviation of the range to a satellite without corrections; smaller for DGPS and RTK. Without GST sentences, position sigma = this × DOP.")
            double rangeError,
        @Variable(min = 1_200, max = 921_600, ifAbsent = 9_600)
            @Description("UBLOX: baud rate of the receiver's port, as in CONNECTION; not changed.")
            int baud,
        @Variable(unit = "Hz", min = 0.1, max = 25, ifAbsent = 5)
            @Description("UBLOX: fixes per second.")
            double solutionRate) {}

    public Provider() {
      super(
          GpsReceiver.class,
          Variables.class,
          (name, link, own) ->
              name.equals("NMEA")
                  ? listening(link, new NmeaGps(own.rangeError()))
                  : ublox(link, UbloxModel.named(name), own.baud(), own.solutionRate()),
          "NMEA",
          "UBLOX 6",
          "UBLOX 8");
    }
  }
}
