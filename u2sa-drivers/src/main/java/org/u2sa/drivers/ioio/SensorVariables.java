package org.u2sa.drivers.ioio;

import org.u2sa.device.port.Compass;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.drivers.compass.LinkedCompass;
import org.u2sa.drivers.gps.LinkedGps;
import org.u2sa.drivers.gps.NmeaGps;
import org.u2sa.drivers.gps.UbloxModel;
import org.u2sa.drivers.gps.UbxGps;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Configuration variables of GPS and compass. */
record SensorVariables(
    @Variable(
            ifAbsentText = "UBLOX 6",
            oneOf = {"NMEA", "UBLOX 6", "UBLOX 8"})
        @Description(
            "NMEA: any receiver, never configured; UBLOX 6: LEA-6 and older, UBLOX 8: generation 7 and newer, both configured at each connection.")
        String gpsReceiver,
    @Variable(unit = "Hz", min = 0.1, max = 25, ifAbsent = 5)
        @Description("Fixes per second of a u-blox receiver.")
        double gpsSolutionRate,
    @Variable(unit = "s", min = 0, max = 5, ifAbsent = 0)
        @Description(
            "Latency from measurement to arrival of a fix's first message, from the data sheet; states are timestamped with the time of measurement.")
        double gpsDelay,
    @Variable(
            ifAbsentText = "SPARTON",
            oneOf = {"NMEA", "SPARTON"})
        @Description(
            "NMEA: any compass that sends HDG, HDM or HDT unprompted; SPARTON: SP3004D and its successors, polled for each heading.")
        String compass,
    @Variable(unit = "s", min = 0, max = 5, ifAbsent = 0)
        @Description(
            "Latency from measurement to arrival of a heading, from the data sheet; states are timestamped with the time of measurement.")
        double compassDelay,
    @Variable(unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
        @Description("Yaw of the compass on the vehicle, clockwise.")
        double compassMountingAngle,
    @Variable(unit = "rad", min = 0, max = Math.PI, ifAbsent = Math.PI / 180)
        @Description("Standard deviation of the heading, from the data sheet.")
        double headingSigma) {
  private static final String NMEA = "NMEA";

  /** Creates the receiver on a line; without a TX pin it is only read. */
  GpsReceiver gps(ByteLink link, PinPlan.Uart pins) {
    if (gpsReceiver.equals(NMEA)) {
      return LinkedGps.listening(link, new NmeaGps());
    }
    if (pins.transmit() == PinPlan.NONE) {
      return LinkedGps.listening(link, new UbxGps());
    }
    return LinkedGps.ublox(link, UbloxModel.named(gpsReceiver), pins.baud(), gpsSolutionRate);
  }

  /**
   * Creates the compass on a line.
   *
   * @throws BadInputException if it must be polled and has no TX pin
   */
  Compass compass(ByteLink link, PinPlan.Uart pins) {
    if (compass.equals(NMEA)) {
      return LinkedCompass.nmea(link);
    }
    if (pins.transmit() == PinPlan.NONE) {
      throw new BadInputException(
          "variable \"COMPASS TX PIN\": a SPARTON compass is polled and needs a TX pin");
    }
    return LinkedCompass.sparton(link);
  }
}
