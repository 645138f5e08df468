package org.u2sa.sim.file;

import java.util.List;
import java.util.function.DoubleFunction;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.world.World;

/**
 * An IOIO board of a vehicle file, with the devices at its pins.
 *
 * @param compass compass as a function of the declination [rad]
 */
record BoardEntry(
    MiniMolle.Wiring wiring, GpsParameters gps, DoubleFunction<CompassParameters> compass) {
  private static final int LAST_PIN = 48;
  private static final int COMPASS_BAUD = 9600;
  private static final double YEAR = 2026.4; // of the simulated receiver's date

  static BoardEntry read(FileElement board) {
    FileElement gpsFile = board.part("gps");
    FileElement compassFile = board.part("compass");
    GpsParameters gps = gpsFile.made(() -> StateSensors.gpsParameters(gpsFile));
    DoubleFunction<CompassParameters> compass = StateSensors.compassParameters(compassFile);
    List<Integer> gpsPins = pins(gpsFile);
    List<Integer> compassPins = pins(compassFile);
    List<Integer> actuators = pins(board);
    MiniMolle.Wiring wiring =
        new MiniMolle.Wiring(
            gpsPins.get(0),
            gpsPins.get(1),
            compassPins.get(0),
            compassPins.get(1),
            actuators.get(0),
            actuators.get(1),
            board.count("radioSwitchPin", 0, LAST_PIN),
            board.count("batteryPin", 0, LAST_PIN),
            1.0 / board.number("batteryDivider", "1", 1.0, 100.0));
    gpsFile.end();
    compassFile.end();
    board.end();
    return new BoardEntry(wiring, gps, compass);
  }

  /** The board's receiving and transmitting pin of a device, or the pins of both actuators. */
  private static List<Integer> pins(FileElement file) {
    List<Double> pins = file.numbers("pins", "1", 0.0, LAST_PIN, 2);
    if (pins.size() != 2 || pins.stream().anyMatch(pin -> pin != Math.rint(pin))) {
      throw file.xml().error("pins: " + pins + ": expected two whole numbers");
    }
    return pins.stream().map(Double::intValue).toList();
  }

  MiniMolle make(World world, GroundVehicle vehicle, Hazards hazards, long seed) {
    return MiniMolle.in(world)
        .vehicle(vehicle)
        .wiring(wiring)
        .gps(gps, UbloxSettings.factory())
        .compass(compass.apply(StateSensors.declinationRad(world, YEAR)), COMPASS_BAUD)
        .hazards(hazards)
        .seed(seed)
        .build();
  }
}
