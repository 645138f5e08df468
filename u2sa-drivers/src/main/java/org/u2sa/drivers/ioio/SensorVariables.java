package org.u2sa.drivers.ioio;

import org.u2sa.device.Compass;
import org.u2sa.device.GpsReceiver;
import org.u2sa.device.TrueNorth;
import org.u2sa.drivers.compass.LinkedCompass;
import org.u2sa.drivers.gps.LinkedGps;
import org.u2sa.drivers.gps.NmeaGps;
import org.u2sa.drivers.gps.UbloxModel;
import org.u2sa.drivers.gps.UbxGps;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables that say what the GPS and the compass are. */
final class SensorVariables {
  private static final String NMEA = "NMEA";
  private static final String SPARTON = "SPARTON";

  static final VariableDeclaration<String> GPS_RECEIVER =
      VariableDeclaration.text("GPS RECEIVER")
          .oneOf(NMEA, "UBLOX 6", "UBLOX 8")
          .ifAbsent("UBLOX 6")
          .describedAs(
              "NMEA: any, only listened to; UBLOX 6: LEA-6 and older, UBLOX 8: 7 and newer, set up at each connection.");

  static final VariableDeclaration<Double> SOLUTION_RATE =
      VariableDeclaration.number("GPS SOLUTION RATE", "Hz")
          .range(Range.of(0.1, 25.0))
          .ifAbsent(5.0)
          .describedAs("Fixes a second of a u-blox receiver.");

  static final VariableDeclaration<String> COMPASS =
      VariableDeclaration.text("COMPASS")
          .oneOf(NMEA, SPARTON)
          .ifAbsent(SPARTON)
          .describedAs(
              "NMEA: any that sends HDG, HDM or HDT by itself; SPARTON: SP3004D and its successors, asked for each heading.");

  static final VariableDeclaration<Double> MOUNTING_ANGLE =
      VariableDeclaration.number("COMPASS MOUNTING ANGLE", "rad")
          .range(Range.of(-Math.PI, Math.PI))
          .ifAbsent(0.0)
          .describedAs("Direction of the compass's front, clockwise from the vehicle's.");

  static final VariableDeclaration<Double> HEADING_SIGMA =
      VariableDeclaration.number("HEADING SIGMA", "rad")
          .range(Range.of(0.0, Math.PI))
          .ifAbsent(Math.toRadians(1.0))
          .describedAs("Standard deviation of the heading, from the data sheet.");

  private final String receiver;
  private final double solutionHz;
  private final String compass;
  private final double mountingRad;
  private final double headingSigmaRad;
  private final TrueNorth north;

  /** Declares and reads them. */
  SensorVariables(Configurator variables) {
    receiver = variables.getVariable(GPS_RECEIVER);
    solutionHz = variables.getVariable(SOLUTION_RATE);
    compass = variables.getVariable(COMPASS);
    mountingRad = variables.getVariable(MOUNTING_ANGLE);
    headingSigmaRad = variables.getVariable(HEADING_SIGMA);
    north = new TrueNorth(variables);
  }

  /** The receiver at a line; if no pin leads to it, it is only listened to. */
  GpsReceiver gps(ByteLink link, UartPins pins) {
    if (receiver.equals(NMEA)) {
      return LinkedGps.listening(link, new NmeaGps());
    }
    if (pins.transmit() == PinPlan.NONE) {
      return LinkedGps.listening(link, new UbxGps());
    }
    return LinkedGps.ublox(link, UbloxModel.named(receiver), pins.baud(), solutionHz);
  }

  /**
   * The compass at a line.
   *
   * @throws BadInputException if it has to be asked and no pin leads to it
   */
  Compass compass(ByteLink link, UartPins pins) {
    if (compass.equals(NMEA)) {
      return LinkedCompass.nmea(link);
    }
    if (pins.transmit() == PinPlan.NONE) {
      throw new BadInputException(
          "variable \"COMPASS TX PIN\": pin -1 is none, and a " + SPARTON + " compass is asked");
    }
    return LinkedCompass.sparton(link);
  }

  TrueNorth north() {
    return north;
  }

  double mountingRad() {
    return mountingRad;
  }

  double headingSigmaRad() {
    return headingSigmaRad;
  }
}
