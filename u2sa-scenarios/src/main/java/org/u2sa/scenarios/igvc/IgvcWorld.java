package org.u2sa.scenarios.igvc;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.ioio.BoardConnection;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.scenarios.run.BoardCable;
import org.u2sa.scenarios.run.HomeFolder;
import org.u2sa.scenarios.run.LaserOnVehicle;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.device.SimulatedColourCamera;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.file.VehicleDevices;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ramp;
import org.u2sa.sim.world.RampedGround;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/** Simulated world of one run: a vehicle on a course, with its sensors and IOIO board. */
final class IgvcWorld {
  private static final double LASER_FORWARD_M = 0.35; // as in LidarSensor.xml
  private static final double LASER_UP_M = 0.4;
  private static final double CAMERA_HZ = 5.0;
  private static final double HALF_TYRE_M = 0.03;

  private static final SimulatedLaser.Optics LASER =
      new SimulatedLaser.Optics(
          10.0, Math.toRadians(-135.0), Math.toRadians(0.5), 541, 0.06, 10.0, 0.03);

  private final Course course;
  private final World world;
  private final VehicleFile file;
  private final MiniMolle vehicle;
  private final BoardCable cable;
  private final long seed;
  private final double cameraDiesS;
  private final double lidarDiesS;
  private final Set<Hardness> hardness;
  private volatile SimulatedLaser laser; // null until requested
  private volatile SimulatedColourCamera camera;

  /**
   * @param origin geographic origin of the course
   * @param cameraDiesS time at which the camera is unplugged [s]; infinite for never
   * @param lidarDiesS time at which the laser is unplugged [s]; infinite for never
   * @param hardness adverse conditions
   */
  IgvcWorld(
      Course course,
      VehicleOutline outline,
      Geodetic origin,
      long seed,
      double cameraDiesS,
      double lidarDiesS,
      Set<Hardness> hardness) {
    this.hardness = hardness;
    this.cameraDiesS = cameraDiesS;
    this.lidarDiesS = lidarDiesS;
    this.course = course;
    this.seed = seed;
    world = ground(World.at(origin), course).with(solids(course));
    Map<String, String> width =
        Map.of(
            "differential/track", "" + outline.trackM(),
            "body/outline/width", "" + (outline.trackM() + 2.0 * HALF_TYRE_M));
    file =
        VehicleFile.load(
            HomeFolder.holding("config/igvc").resolve("config/igvc/vehicle.xml"), width);
    Course.Start start = course.start();
    vehicle =
        file.board(
            world,
            Point.of(start.eastM(), start.northM(), 0.0),
            start.headingRad(),
            Hardness.hazards(hardness, course, new NoiseStreams(seed)),
            seed);
    cable = new BoardCable(vehicle);
  }

  private static World ground(World lawn, Course course) {
    List<Ramp> ramps = course.ramps().stream().map(Course.NamedRamp::ramp).toList();
    if (ramps.isEmpty()) {
      return lawn;
    }
    RampedGround ground = new RampedGround(ramps);
    return lawn.with((Terrain) ground).with((Surface) ground);
  }

  /** Objects visible to a level laser, i.e. all but paint. */
  private static List<ObjectDescription> solids(Course course) {
    return course.objects().stream()
        .filter(object -> object instanceof Cylinder || object instanceof Box)
        .toList();
  }

  BoardConnection connection() {
    return cable.connection();
  }

  IoioFirmware board() {
    return cable.board();
  }

  /** Latest ground truth. Thread-safe. */
  VehicleTruth truth() {
    return vehicle.truth();
  }

  World world() {
    return world;
  }

  VehicleDevices devices() {
    return new VehicleDevices(file, vehicle, seed);
  }

  LaserScanner laser() {
    laser =
        new SimulatedLaser(
            LASER,
            Hardness.laser(hardness),
            new NoiseStreams(seed),
            new LaserOnVehicle(world, this::truth, LASER_FORWARD_M, LASER_UP_M, LASER.farthestM()));
    time(0.0);
    return laser;
  }

  /** Unplugs the devices that fail by this time of the run [s]. */
  void time(double nowS) {
    if (camera != null && nowS >= cameraDiesS) {
      camera.plug(false);
    }
    if (laser != null && nowS >= lidarDiesS) {
      laser.plug(false);
    }
  }

  /** A camera with the seed's lighting. */
  Camera camera() {
    NoiseStreams streams = new NoiseStreams(seed);
    Light light = Light.random(streams.of("light"));
    Scenery scenery = new Scenery(course.objects(), light, seed);
    camera =
        new SimulatedColourCamera(ColourLens.mast().rate(CAMERA_HZ), scenery, streams, this::truth);
    time(0.0);
    return camera;
  }
}
