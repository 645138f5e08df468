package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.device.payload.Gimbal;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.device.port.MotorController;
import org.u2sa.device.port.Servo;
import org.u2sa.device.port.Thruster;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.world.ScriptedMover;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

class VehicleDevicesTest {
  /** A device that vehicle files do not know. */
  private interface Winch extends Device<Device.Reading> {}

  private final LockstepClock clock = new LockstepClock();

  private VehicleRun run(VehicleFile file) {
    return new VehicleRun(file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1));
  }

  private static XmlConfiguration variables(Object... more) {
    Map<String, Object> variables = new HashMap<>();
    for (int i = 0; i < more.length; i += 2) {
      variables.put((String) more[i], more[i + 1]);
    }
    return XmlConfiguration.inMemory("the test", variables);
  }

  private <D extends Device<?>> Optional<D> device(
      VehicleFile file, Class<D> port, String service, XmlConfiguration variables) {
    return new VehicleDevices(file, run(file), 1).device(port, service, variables, clock);
  }

  @Test
  void device_sensorThatTheVehicleLacks_isRefusedWithServiceAndWhatThereIs() {
    VehicleFile file = Vehicles.parse(Vehicles.sixWheels());

    assertThatThrownBy(() -> device(file, LaserScanner.class, "FrontLaser", variables()))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "vehicle.xml: service \"FrontLaser\" needs a LaserScanner, which the vehicle lacks; it has"
                + " <gps>, <compass>, <imu>, LEFT MOTOR, RIGHT MOTOR");
  }

  @Test
  void device_thrusterOfAnotherName_isRefusedWithTheNamesOfThoseThere() {
    VehicleFile file = Vehicles.parse(Vehicles.threeThrusters());

    assertThatThrownBy(() -> device(file, Thruster.class, "STERN", variables()))
        .hasMessageContaining("needs a Thruster \"STERN\"")
        .hasMessageEndingWith("PORT, STARBOARD, BOW");
    assertThatThrownBy(() -> device(file, MotorController.class, "WheelMotors", variables()))
        .hasMessageContaining("needs a MotorController");
  }

  @Test
  void device_portOfNoVehicleFile_isLeftToTheConfiguration() {
    VehicleFile file = Vehicles.parse(Vehicles.sixWheels());

    assertThat(device(file, Winch.class, "Winch", variables())).isEmpty();
  }

  @Test
  void device_radarAndTrafficReceiver_seeMoversOfTheWorld() {
    VehicleFile file =
        Vehicles.parse(
            Vehicles.sixWheels()
                .replace(
                    "</vehicle>",
                    "<radar><rate>1</rate><delay>0</delay><sigma>0</sigma><bias>0</bias><reach>500</reach><angleSigma>0</angleSigma><position>0 0 -1</position></radar>"
                        + "<trafficReceiver><rate>1</rate><delay>0</delay><sigma>0</sigma><bias>0</bias><reach>500</reach></trafficReceiver></vehicle>"));
    World empty = file.emptyWorld();
    ScriptedMover near = mover("near", Point.of(0.0, 60.0, 2.0), empty, true);
    ScriptedMover behindWall = mover("hidden", Point.of(100.0, 0.0, 2.0), empty, false);
    Box wall = new Box();
    wall.length(1.0).width(20.0).height(20.0);
    wall.uid("wall").referenceFrame(ReferenceFrame.LOCAL_ENU).x(50.0).y(0.0);
    World world = empty.with(List.of(wall)).withMovers(List.of(near, behindWall));
    VehicleDevices devices =
        new VehicleDevices(file, new VehicleRun(file.make(world, Point.ORIGIN, 0.0, 1)), 1);
    TrackingRadar radar =
        devices.device(TrackingRadar.class, "Radar", variables(), clock).orElseThrow();
    TrafficReceiver receiver =
        devices.device(TrafficReceiver.class, "Traffic", variables(), clock).orElseThrow();

    List<TrackingRadar.Track> tracks = radar.read(0L).orElseThrow().tracks();
    assertThat(tracks).extracting(TrackingRadar.Track::id).containsExactly("near");
    assertThat(tracks.get(0).rangeM()).isCloseTo(60.0, within(0.1));
    assertThat(tracks.get(0).speedMps().orElseThrow()).isCloseTo(3.0, within(1e-9));
    assertThat(receiver.read(0L).orElseThrow().targets())
        .extracting(TrafficTarget::id)
        .containsExactly("near");
  }

  private static ScriptedMover mover(String name, Point from, World world, boolean hasTransponder) {
    Sphere body = new Sphere();
    body.radius(1.0).uid(name).referenceFrame(ReferenceFrame.LOCAL_ENU);
    body.x(from.x()).y(from.y()).z(from.z());
    Point to = from.plus(Point.of(0.0, 90.0, 0.0));
    return new ScriptedMover(
        body,
        world.plane(),
        List.of(new ScriptedMover.Waypoint(to, 3.0, 0.0)),
        ScriptedMover.End.STOP,
        0.0,
        false,
        hasTransponder);
  }

  @Test
  void device_renderedCameras_showColourAndTemperature() {
    for (String picture : new String[] {"COLOUR", "THERMAL"}) {
      VehicleFile file =
          Vehicles.parse(
              Vehicles.sixWheels()
                  .replace(
                      "</vehicle>",
                      "<camera><rate>5</rate><width>32</width><height>24</height><view>1</view><sigma>0.01</sigma><picture>"
                          + picture
                          + "</picture>"
                          + (picture.equals("THERMAL")
                              ? "<coldest>260</coldest><hottest>330</hottest>"
                              : "<waterType>IB</waterType>")
                          + "<position>0 0 -1</position></camera></vehicle>"));
      World sea = file.emptyWorld().with(new Water(0.0, 0.0, 0.0));
      Buoy buoy = new Buoy().radius(0.4).colour(Colour.RED);
      buoy.uid("1").referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(6.0);
      World world = sea.with(List.of(buoy));
      VehicleDevices devices =
          new VehicleDevices(file, new VehicleRun(file.make(world, Point.ORIGIN, 0.0, 1)), 1);
      Camera camera = devices.device(Camera.class, "Eye", variables(), clock).orElseThrow();
      CameraFrame frame = camera.read(0L).orElseThrow();

      assertThat(frame.format())
          .isEqualTo(
              picture.equals("COLOUR")
                  ? CameraFrame.PixelFormat.RGB24
                  : CameraFrame.PixelFormat.GREY8);
      assertThat(frame.intrinsics()).isPresent();
    }
  }

  @Test
  void device_sensorOfOneService_isNotAnothers() {
    VehicleFile file =
        Vehicles.parse(
            Vehicles.sixWheels()
                .replace("<gps preset=\"survey\"/>", "<gps service=\"Rover\" preset=\"phone\"/>"));

    assertThat(device(file, GpsReceiver.class, "Rover", variables())).isPresent();
    assertThatThrownBy(() -> device(file, GpsReceiver.class, "GpsSensor", variables()))
        .hasMessageContaining("<gps service=\"Rover\">");
  }

  @Test
  void read_afterTheSensorsFailure_isDisconnected() throws InterruptedException {
    VehicleFile file =
        Vehicles.parse(
            Vehicles.sixWheels()
                .replace(
                    "<gps preset=\"survey\"/>",
                    "<gps preset=\"survey\"><failsAt unit=\"s\">2</failsAt></gps>"));
    GpsReceiver receiver = device(file, GpsReceiver.class, "GpsSensor", variables()).orElseThrow();
    receiver.read(0L);
    clock.runUntil(() -> false, 1_900_000L);
    receiver.read(1_900_000L);
    boolean before = receiver.isConnected();
    clock.runUntil(() -> false, 2_000_000L);
    receiver.read(2_000_000L);

    assertThat(before).isTrue();
    assertThat(receiver.isConnected()).isFalse();
  }

  @Test
  void device_receiver_setsDelayUnlessTheServiceStatesOne() {
    VehicleFile file = Vehicles.parse(Vehicles.sixWheels());
    XmlConfiguration open = variables();
    XmlConfiguration stated = variables("DELAY", 0.2);
    device(file, GpsReceiver.class, "GpsSensor", open);
    device(file, GpsReceiver.class, "GpsSensor", stated);

    assertThat(open.overrides()).containsEntry("DELAY", 0.06);
    assertThat(stated.overrides()).isEmpty();
  }

  @Test
  void device_motors_driveTheVehicleUntilTheirTimeOut() {
    VehicleFile file = Vehicles.parse(Vehicles.sixWheels());
    VehicleRun run = run(file);
    MotorController motors =
        new VehicleDevices(file, run, 1)
            .device(MotorController.class, "WheelMotors", variables(), clock)
            .orElseThrow();
    motors.drive(100.0, 100.0);
    motors.read(0L);
    double driving = run.at(500_000L).speedMps();

    assertThat(driving).isGreaterThan(0.5);
    assertThat(run.at(10_000_000L).speedMps()).isCloseTo(0.0, within(0.05));
  }

  @Test
  void device_servo_deflectsItsSurfaceAndKnowsItsTravel() throws Exception {
    VehicleFile file = VehicleFile.load(Path.of("../config/ugv/vehicle-ackermann.xml"));
    VehicleRun run = run(file);
    VehicleDevices devices = new VehicleDevices(file, run, 1);
    XmlConfiguration open = variables();
    Servo steering = devices.device(Servo.class, "STEERING", open, clock).orElseThrow();
    run.command(0L, "THROTTLE", 0.5);
    steering.turn(0.4189);
    steering.read(0L);

    assertThat(open.overrides()).containsEntry("TRAVEL", 0.4189);
    assertThat(run.at(2_000_000L).rates().z()).isGreaterThan(0.5);
    assertThatThrownBy(() -> devices.device(Thruster.class, "STEERING", variables(), clock))
        .hasMessageContaining("needs a Thruster \"STEERING\"");
  }

  @Test
  void device_thruster_pushesAndStopsAtOnce() {
    VehicleFile file = Vehicles.parse(Vehicles.threeThrusters());
    VehicleRun run = run(file);
    VehicleDevices devices = new VehicleDevices(file, run, 1);
    Thruster bow =
        devices.device(Thruster.class, "X", variables("ACTUATOR NAME", "BOW"), clock).orElseThrow();
    bow.thrust(100.0);
    bow.read(0L);
    double turning = run.at(400_000L).rates().z();
    bow.stop(400_000L);

    assertThat(turning).isGreaterThan(0.1);
    assertThat(Math.abs(run.at(30_000_000L).rates().z())).isLessThan(0.01);
  }

  @Test
  void device_thrusterThatFails_isDisconnectedFromThen() throws InterruptedException {
    VehicleFile file =
        Vehicles.parse(
            Vehicles.threeThrusters()
                .replaceFirst(
                    "(<thruster name=\"BOW\"[^>]*>)", "$1<failsAt unit=\"s\">1</failsAt>"));
    Thruster bow =
        device(file, Thruster.class, "X", variables("ACTUATOR NAME", "BOW")).orElseThrow();
    bow.read(clock.micros());
    boolean before = bow.isConnected();
    clock.advance(1_100_000L);
    bow.read(clock.micros());

    assertThat(before).isTrue();
    assertThat(bow.isConnected()).isFalse();
  }

  @Test
  void device_payloads_areTheVehiclesWithTheirLimits() {
    VehicleFile file =
        Vehicles.parse(
            Vehicles.sixWheels()
                .replace(
                    "<gps preset=\"survey\"/>",
                    "<gps preset=\"survey\"/><gimbal><rate unit=\"Hz\">50</rate>"
                        + "<pan unit=\"rad\">2</pan><lowestTilt unit=\"rad\">-1</lowestTilt>"
                        + "<highestTilt unit=\"rad\">0.5</highestTilt>"
                        + "<maxRate unit=\"rad/s\">1</maxRate><lag unit=\"s\">0.1</lag></gimbal>"
                        + "<servo><rate unit=\"Hz\">50</rate><lowest unit=\"rad\">-0.5</lowest>"
                        + "<highest unit=\"rad\">1.5</highest><maxRate unit=\"rad/s\">5</maxRate>"
                        + "<lag unit=\"s\">0.1</lag></servo>"));
    XmlConfiguration gimbal = variables();
    XmlConfiguration joint = variables("ACTUATOR NAME", "ELBOW");

    assertThat(device(file, Gimbal.class, "GimbalActuator", gimbal)).isPresent();
    assertThat(gimbal.overrides()).containsEntry("MINIMUM TILT", -1.0);
    assertThat(device(file, Servo.class, "Elbow", joint)).isPresent();
    assertThat(joint.overrides()).containsEntry("TRAVEL", 1.5);
  }

  private static VehicleFile boatWithLoadCell(String thruster) {
    return Vehicles.parse(
        Vehicles.threeThrusters()
            .replace(
                "</vehicle>",
                "<loadCell><rate unit=\"Hz\">20</rate><delay unit=\"s\">0</delay>"
                    + "<sigma unit=\"N\">0</sigma><bias unit=\"N\">0</bias><thruster>"
                    + thruster
                    + "</thruster></loadCell></vehicle>"));
  }

  @Test
  void read_loadCell_isTheThrustOfItsThruster() throws InterruptedException {
    VehicleFile file = boatWithLoadCell("PORT");
    VehicleRun run = run(file);
    LoadCell cell =
        new VehicleDevices(file, run, 1)
            .device(LoadCell.class, "ThrustSensor", variables(), clock)
            .orElseThrow();
    double before = cell.read(0L).orElseThrow().newtons();
    run.command(0L, "PORT", 1.0);
    clock.runUntil(() -> false, 5_000_000L);

    assertThat(before).isZero();
    assertThat(cell.read(5_000_000L).orElseThrow().newtons()).isGreaterThan(10.0);
  }

  @Test
  void device_loadCellOfNoThruster_isRefusedByName() {
    assertThatThrownBy(
            () -> device(boatWithLoadCell("STERN"), LoadCell.class, "ThrustSensor", variables()))
        .hasMessageContaining("no thruster \"STERN\" whose thrust is computed");
  }
}
