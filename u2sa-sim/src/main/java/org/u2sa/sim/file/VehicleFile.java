package org.u2sa.sim.file;

import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.file.element.VehicleChanges;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.vehicle.ContactWatch;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/** A vehicle read from a file (docs/vehicle-files.md). Immutable. */
public final class VehicleFile {
  private static final String ROOT = "vehicle";
  private static final double PROBE_S = 1.0;
  private static final double REVERSED_S = 0.1;
  private static final double FASTEST_MPS = 1_000.0;

  private final String origin;
  private final String name;
  private final Body body;
  private final VehicleModel model;
  private final List<SensorEntry> sensors;
  private final Optional<BoardEntry> board;

  private VehicleFile(XmlElement root) {
    FileElement vehicle = new FileElement(root);
    origin = root.origin();
    name = vehicle.text("name");
    body =
        root.child("jsbsim").isPresent()
            ? Body.outline(vehicle.part("body"))
            : Body.read(vehicle.part("body"));
    model = VehicleModels.read(vehicle, body);
    sensors = SensorKinds.read(vehicle, model);
    board = vehicle.optionalPart("ioio").map(this::board);
    vehicle.end();
    probe(root);
  }

  private BoardEntry board(FileElement file) {
    if (!(model instanceof GroundModel)) {
      throw file.xml().error("is for ground vehicles only");
    }
    return BoardEntry.read(file);
  }

  /**
   * Reads a vehicle.
   *
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static VehicleFile load(Path file) {
    return new VehicleFile(XmlReader.read(file, ROOT));
  }

  /**
   * Reads a vehicle with some values of its file replaced.
   *
   * @param changes values by element path, such as {@code body/mass} or {@code gps/@preset}
   * @throws BadInputException as {@link #load(Path)}, also if there is no such path
   */
  public static VehicleFile load(Path file, Map<String, String> changes) {
    return new VehicleFile(VehicleChanges.apply(XmlReader.read(file, ROOT), changes));
  }

  /**
   * Reads a vehicle from a stream, without closing it.
   *
   * @param origin name of the source in messages
   * @throws BadInputException as {@link #load}
   */
  public static VehicleFile read(InputStream in, String origin) {
    return new VehicleFile(XmlReader.read(in, origin, ROOT));
  }

  private SimulatedVehicle probed(XmlElement root) {
    try {
      return make(emptyWorld(), Point.ORIGIN, 0.0, 1);
    } catch (IllegalArgumentException e) { // invalid combination of valid values
      throw root.error("cannot be simulated: " + e.getMessage(), e);
    }
  }

  /** Rejects parameters whose motion cannot be integrated at a fixed rate. */
  private void probe(XmlElement root) {
    for (int pattern = 0;
        pattern < 4;
        pattern++) { // all ahead, all astern, alternating; each is reversed
      SimulatedVehicle vehicle = probed(root);
      double speed = Double.NaN;
      try {
        command(vehicle, pattern);
        vehicle.step(PROBE_S);
        speed = vehicle.truth().velocity().distance() + vehicle.truth().rates().distance();
        command(vehicle, ~pattern);
        vehicle.step(REVERSED_S);
      } catch (IllegalArgumentException e) {
        throw root.error("its motion diverges: " + e.getMessage(), e);
      }
      if (!(speed < FASTEST_MPS)) {
        throw root.error(
            "with full commands it reaches "
                + speed
                + " m/s and rad/s within "
                + PROBE_S
                + " s; expected less than "
                + FASTEST_MPS
                + ": are mass, inertia and forces in the right units?");
      }
    }
  }

  /** Commands full ahead where a bit of the pattern is 0: even actuators its last, odd the next. */
  private void command(SimulatedVehicle vehicle, int pattern) {
    for (int i = 0; i < model.actuators().size(); i++) {
      String actuator = model.actuators().get(i);
      boolean isFull = (pattern >> i % 2 & 1) == 0;
      vehicle.command(actuator, isFull ? 1.0 : model.lowest(actuator));
    }
  }

  /** An empty level world in which the vehicle can move, with deep water for a vessel. */
  public World emptyWorld() {
    return home(World.at(new Geodetic(0.0, 0.0, 0.0)));
  }

  /** The world, with still water up to its plane added if the vehicle needs water. */
  public World home(World world) {
    return model.medium() == VehicleModel.Medium.WATER && world.water().isEmpty()
        ? world.with(new Water(0.0, 0.0, 0.0))
        : world;
  }

  /** The file, as named by the user. */
  public String origin() {
    return origin;
  }

  /** The vehicle's name. */
  public String name() {
    return name;
  }

  /** Its mass [kg]. */
  public double massKg() {
    return model.massKg().orElse(body.massKg());
  }

  /** Its dynamics. */
  public VehicleModel model() {
    return model;
  }

  Optional<BoardEntry> board() {
    return board;
  }

  List<SensorEntry> sensors() {
    return sensors;
  }

  /** Whether it has an IOIO board. */
  public boolean hasBoard() {
    return board.isPresent();
  }

  /**
   * Creates a vehicle at rest behind its IOIO board.
   *
   * @throws BadInputException if it has none
   */
  public MiniMolle board(World world, Point start, double headingRad, Hazards hazards, long seed) {
    BoardEntry entry =
        board.orElseThrow(
            () ->
                new BadInputException(
                    origin + ": has no IOIO board, which IoioService needs; expected <ioio>"));
    GroundVehicle placed = ((GroundModel) model).make(world, start, headingRad, seed);
    return entry.make(world, free(placed), hazards, seed);
  }

  /** Creates a vehicle at rest, to be shared by the services and observers of a run. */
  public RunningVehicle running(World world, Point start, double headingRad, long seed) {
    VehicleRun run = new VehicleRun(make(world, start, headingRad, seed));
    return model.isSteppedByOwner() ? run.readers() : run;
  }

  /**
   * Creates a vehicle at rest.
   *
   * @param start east, north, up [m]; up is above the ground, except for vessels
   * @param headingRad clockwise from north [rad]
   * @param seed seed of the deviations from nominal parameters
   * @throws BadInputException if the vehicle touches an object there, or a vessel the bed
   */
  public SimulatedVehicle make(World world, Point start, double headingRad, long seed) {
    double groundM =
        model.medium() == VehicleModel.Medium.WATER
            ? 0.0
            : world.terrain().heightM(start.x(), start.y());
    Point place = start.plus(Point.of(0.0, 0.0, groundM));
    return free(model.make(world, place, headingRad, seed));
  }

  private <T extends SimulatedVehicle> T free(T vehicle) {
    VehicleTruth truth = vehicle.truth();
    List<String> touched = ContactWatch.touched(vehicle, truth);
    if (!touched.isEmpty()) {
      Point at = truth.position();
      throw new BadInputException(
          String.format(
              Locale.ROOT,
              "%s: where the vehicle starts, %.2f m east, %.2f m north and %.2f m up in the world, it touches %s; expected a free place",
              origin,
              at.x(),
              at.y(),
              at.z(),
              String.join(", ", touched)));
    }
    return vehicle;
  }
}
