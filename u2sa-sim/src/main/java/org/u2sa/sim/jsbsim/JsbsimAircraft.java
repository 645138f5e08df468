package org.u2sa.sim.jsbsim;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** An aircraft read from a JSBSim file (docs/vehicle-files.md). Immutable. */
public final class JsbsimAircraft {
  private static final double SETTLES_S = 20.0;
  private static final double SURFACES_MOVE_S = 600.0;

  private final AircraftFiles files;
  private final Map<String, Double> properties;
  private final List<String> actuators;
  private final List<String> ignored;
  private final Map<String, Double> travels = new HashMap<>(); // by actuator [rad]
  private final double massKg;
  private final double standsM;
  private final Attitude stands;

  private JsbsimAircraft(AircraftFiles files, Map<String, Double> properties) {
    this.files = files;
    this.properties = Map.copyOf(properties);
    JsbsimLoads loads = loads(Map.of());
    actuators = List.copyOf(loads.actuators());
    massKg = loads.start().massKg();
    ignored = new ArrayList<>(files.ignored());
    ignored.addAll(loads.ignored());
    travels.putAll(loads.travels(SURFACES_MOVE_S));
    VehicleTruth resting = settle();
    standsM = resting.position().z();
    stands = resting.attitude();
  }

  /**
   * Reads an aircraft.
   *
   * @param file the aircraft; engines, propellers and systems are beside it or in one of JSBSim's
   *     folders
   * @param properties values by JSBSim's property names; they override the file's
   * @throws org.u2sa.interfaces.BadInputException naming file, line, element and what was expected
   */
  public static JsbsimAircraft read(Path file, Map<String, Double> properties) {
    return new JsbsimAircraft(new AircraftFiles(file), properties);
  }

  private JsbsimLoads loads(Map<String, Double> more) {
    Map<String, Double> given = new HashMap<>(properties);
    given.putAll(more);
    return new JsbsimLoads(files, new PropertyTree(given));
  }

  /** Height and attitude at rest on level ground, with engines idling and brakes set. */
  private VehicleTruth settle() {
    Footprint point = Footprint.rectangle(0.1, 0.1, 0.2, -0.1, 0.1);
    World level = World.at(new Geodetic(0.0, 0.0, 0.0));
    JsbsimLoads loads = loads(Map.of());
    double reach = loads.wheels().stream().mapToDouble(wheel -> wheel.z()).max().orElse(0.0);
    UnmannedAircraft aircraft =
        UnmannedAircraft.of(loads, loads.wheels(), point, level, Point.of(0.0, 0.0, reach), 0.0);
    for (String brake : List.of("LEFT BRAKE", "RIGHT BRAKE")) {
      if (actuators.contains(brake)) {
        aircraft.command(brake, 1.0);
      }
    }
    aircraft.step(loads.wheels().isEmpty() ? 0.01 : SETTLES_S);
    return aircraft.truth();
  }

  /** Names of its actuators. */
  public List<String> actuators() {
    return actuators;
  }

  /** Lowest command of an actuator: −1, or 0. */
  public double lowest(String actuator) {
    return ControlLever.of(actuator).lowest();
  }

  /** Largest angle of an actuator's surface at full command [rad]; empty if it moves no surface. */
  public OptionalDouble travelRad(String actuator) {
    return travels.containsKey(actuator)
        ? OptionalDouble.of(travels.get(actuator))
        : OptionalDouble.empty();
  }

  /** Ignored elements of the file, with line numbers. */
  public List<String> ignored() {
    return List.copyOf(ignored);
  }

  /** Mass at the start [kg]. */
  public double massKg() {
    return massKg;
  }

  /**
   * Creates the aircraft on its wheels, engines idling.
   *
   * @param ground below the aircraft: east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public JsbsimFlight standing(Footprint footprint, World world, Point ground, double headingRad) {
    JsbsimFlight flight =
        flight(Map.of(), footprint, world, ground.plus(Point.of(0.0, 0.0, standsM)), headingRad);
    Attitude attitude = new Attitude(stands.phi(), stands.theta(), headingRad);
    flight.aircraft().fly(attitude, Point.ORIGIN);
    return flight;
  }

  /**
   * Creates the aircraft, level and at rest, engines idling.
   *
   * @param more properties besides the aircraft's, such as an engine's speed
   * @param start centre of gravity: east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public JsbsimFlight flight(
      Map<String, Double> more, Footprint footprint, World world, Point start, double headingRad) {
    JsbsimLoads loads = loads(more);
    return new JsbsimFlight(
        UnmannedAircraft.of(loads, loads.wheels(), footprint, world, start, headingRad), loads);
  }
}
