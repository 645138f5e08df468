package org.u2sa.scenarios.igvc;

import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.ioio.BoardConnection;
import org.u2sa.drivers.ioio.LockstepConnection;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.scenarios.run.LaserOnVehicle;
import org.u2sa.scenarios.run.SimulatedSensors;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.device.SimulatedColourCamera;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.ground.BatteryParameters;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ground.MotorParameters;
import org.u2sa.sim.ground.Payload;
import org.u2sa.sim.ground.TyreParameters;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ramp;
import org.u2sa.sim.world.RampedGround;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/** Simulated world of one run: a vehicle on a course, with its sensors and IOIO board. */
final class IgvcWorld {
  private static final int COMPASS_BAUD = 9600;
  private static final double YEAR = 2026.4;
  private static final double MAX_MISMATCH = 0.05;
  private static final double PAYLOAD_KG = 9.1; // the rules' 20 lb
  private static final double LASER_FORWARD_M = 0.35; // as in LidarSensor.xml
  private static final double LASER_UP_M = 0.4;
  private static final double CAMERA_HZ = 5.0;

  private static final SimulatedLaser.Optics LASER =
      new SimulatedLaser.Optics(
          10.0, Math.toRadians(-135.0), Math.toRadians(0.5), 541, 0.06, 10.0, 0.03);

  /** DGPS receiver: error of 0.35 m with a correlation time of a minute and a half. */
  private static final GpsParameters RECEIVER =
      new GpsParameters(5.0, 0.1, 0.04, 0.35, 90.0, 1.6, 0.05, 0.0, 1.0, 12, 2);

  private final Course course;
  private final World world;
  private final MiniMolle vehicle;
  private final DifferentialParameters measures;
  private final IoioInProcess cable;
  private final IoioFirmware board;
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
    double mismatch = new SplittableRandom(seed).nextDouble() * 2.0 * MAX_MISMATCH - MAX_MISMATCH;
    measures = measures(outline.trackM(), mismatch);
    Course.Start start = course.start();
    GroundStart at = new GroundStart(start.eastM(), start.northM(), start.headingRad());
    double declinationRad =
        MagneticModel.declinationRad(
            origin.latitudeDeg(), origin.longitudeDeg(), origin.altitudeM(), YEAR);
    vehicle =
        MiniMolle.in(world)
            .vehicle(new DifferentialVehicle(measures, at))
            .gps(RECEIVER, UbloxSettings.factory())
            .compass(CompassParameters.calibrated(declinationRad), COMPASS_BAUD)
            .hazards(Hardness.hazards(hardness, course, new NoiseStreams(seed)))
            .seed(seed)
            .build();
    board = new IoioFirmware(IoioBoard.OTG, vehicle);
    cable = new IoioInProcess(board);
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

  /** 30 kg on wheels of 16 in, with the Mini-Molle's motors and its payload in the middle. */
  private static DifferentialParameters measures(double trackM, double mismatch) {
    return new DifferentialParameters(
        30.0,
        3.1,
        0.08,
        0.25,
        trackM,
        0.37,
        0.05,
        0.20,
        0.03,
        mismatch,
        MotorParameters.pg27(),
        TyreParameters.wheelbarrow(),
        BatteryParameters.leadAcid7Ah(),
        new Payload(PAYLOAD_KG, 0.08, 0.0));
  }

  BoardConnection connection() {
    return new LockstepConnection(
        cable::connect, cable::disconnect, cable::input, cable::output, cable::exchange);
  }

  IoioFirmware board() {
    return board;
  }

  /** Latest ground truth. Thread-safe. */
  VehicleTruth truth() {
    return vehicle.truth();
  }

  World world() {
    return world;
  }

  SimulatedSensors sensors() {
    SimulatedSensors sensors =
        new SimulatedSensors(
            seed, world.plane(), () -> new SimulatedSensors.Moment(truth(), Point.ORIGIN));
    return sensors.wheels(
        () -> vehicle.state().leftWheelRad(),
        () -> vehicle.state().rightWheelRad(),
        measures.wheelRadiusM(),
        measures.trackM());
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
