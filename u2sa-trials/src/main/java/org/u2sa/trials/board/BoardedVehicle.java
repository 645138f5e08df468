package org.u2sa.trials.board;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.file.VehiclePins;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ioio.Pins;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/**
 * A vehicle connected to the pins of a board. Thread-safe except for the pins.
 *
 * @param pins the board's side
 * @param run the vehicle
 * @param commands commands that its actuators receive, by name; NaN for no signal
 * @param wiring actuators and their pins, as text
 */
record BoardedVehicle(
    Pins pins, RunningVehicle run, Supplier<Map<String, Double>> commands, String wiring) {
  /** Duration for which the vehicle does not advance after a start [µs]. */
  static final long BEFORE_THE_START = 0;

  /** Places a vehicle at the origin of its world, behind its file's board or the default one. */
  static BoardedVehicle of(VehicleFile file, World world, double headingRad, long seed) {
    List<String> names = file.model().actuators();
    if (file.hasBoard()) {
      MiniMolle board = file.board(world, Point.ORIGIN, headingRad, Hazards.none(), seed);
      return new BoardedVehicle(
          board,
          board,
          () -> {
            Map<String, Double> commands = new LinkedHashMap<>();
            commands.put(names.get(0), board.command().first());
            commands.put(names.get(1), board.command().second());
            return commands;
          },
          names.get(0) + ", " + names.get(1) + " at the pins of <ioio>");
    }
    VehicleRun run = new VehicleRun(file.make(world, Point.ORIGIN, headingRad, seed));
    VehiclePins pins = new VehiclePins(file, run, seed);
    String wiring =
        pins.actuators().entrySet().stream()
            .map(each -> each.getValue() + "=" + each.getKey())
            .collect(Collectors.joining(", "));
    return new BoardedVehicle(pins, run, pins::commands, wiring);
  }

  /** Current state; only the running board advances the vehicle. */
  VehicleTruth truth() {
    return run.at(BEFORE_THE_START);
  }

  Map<String, Double> outputs() {
    return commands.get();
  }

  /** True position. */
  Geodetic place(VehicleTruth truth) {
    Point at = truth.position();
    return run.vehicle().world().plane().at(at.x(), at.y(), at.z());
  }
}
