package org.u2sa.control.cascade;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.device.ThrusterActuator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.sim.marine.BlueRov2;
import org.u2sa.sim.marine.Vessel;
import org.u2sa.sim.marine.VesselThruster;
import org.u2sa.sim.vehicle.VehicleRun;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/**
 * A seventh thruster, added to a BlueROV2 by a line in its system file and a configuration file
 * (stories 8 and 9): no code, and nothing else in the configuration, knows of it.
 */
class AddedThrusterTest {
  private static final Point TARGET = Point.of(2.0, 0.0, 10.0); // north, east, down [m]
  private static final String SYSTEM =
      """
      <system id="rov">
        <service class="%s"/>
      %s  <service class="org.u2sa.control.cascade.AllocatingControl" configuration="Control.xml"/>
      </system>
      """;

  @TempDir Path directory;

  private final LockstepClock clock = new LockstepClock();
  private final Map<String, VesselPropeller> propellers = new LinkedHashMap<>();
  private VehicleRun run;

  /** Says where the vessel is and where it is to go. */
  static final class Pilot extends PeriodicService {
    private final VehicleRun run;

    Pilot(ServiceContext context, VehicleRun run) {
      super(context, ServiceRole.STATE_ESTIMATOR, "Pilot", 20.0);
      this.run = run;
      registerPublisher(Channels.STATE);
      registerPublisher(Channels.NAVIGATION);
    }

    @Override
    protected void step(double nowS) {
      VehicleTruth truth = run.at(clock().micros());
      Point rates = truth.attitude().eulerRates(truth.rates());
      Point at = Point.of(truth.position().y(), truth.position().x(), -truth.position().z());
      publish(Channels.NAVIGATION, NavigationPoint.at(truth.attitude().bodyOf(TARGET.minus(at))));
      publish(
          Channels.STATE,
          new StateInformation()
              .referenceFrame(ReferenceFrame.LOCAL_NED)
              .x(at.x())
              .y(at.y())
              .z(at.z())
              .xDot(truth.velocity().y())
              .yDot(truth.velocity().x())
              .zDot(-truth.velocity().z())
              .phi(truth.attitude().phi())
              .theta(truth.attitude().theta())
              .psi(truth.attitude().psi())
              .phiDot(rates.x())
              .thetaDot(rates.y())
              .psiDot(rates.z()));
    }
  }

  /** The hull has a place for a seventh thruster, at the stern, pushing ahead. */
  private static List<VesselThruster> thrusters() {
    List<VesselThruster> all = new ArrayList<>(BlueRov2.thrusters());
    VesselThruster first = all.get(0);
    all.add(
        new VesselThruster(
            "THRUSTER 7",
            Point.of(-0.2, 0.0, 0.0),
            Point.of(1.0, 0.0, 0.0),
            first.forwardN(),
            first.reverseN(),
            first.deadband(),
            first.exponent(),
            first.timeConstantS(),
            first.fullPowerW()));
    return all;
  }

  @BeforeEach
  void build() throws IOException {
    World world = World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, 0.1, -0.15));
    run =
        new VehicleRun(
            new Vessel(
                BlueRov2.hull(),
                thrusters(),
                Footprint.rectangle(0.23, 0.23, 0.34, -0.125, 0.125),
                world,
                SixThrusterDive.START,
                0.0));
    Map<String, Object> tuning = SixThrusterDive.tuning();
    tuning.put("WATCHES RESPONSE", false);
    write("Control.xml", tuning);
    for (VesselThruster each : thrusters()) {
      write(each.name() + ".xml", SixThrusterDive.measuring(each));
      propellers.put(each.name(), new VesselPropeller(run, each.name()));
    }
  }

  private void write(String file, Map<String, Object> variables) throws IOException {
    StringBuilder lines = new StringBuilder("<configuration>\n");
    variables.forEach(
        (name, value) -> {
          String type =
              value instanceof String ? "string" : value instanceof Boolean ? "boolean" : "double";
          lines.append(
              "  <variable name=\"%s\" type=\"%s\" value=\"%s\"/>%n".formatted(name, type, value));
        });
    Files.writeString(directory.resolve(file), lines + "</configuration>\n", UTF_8);
  }

  private RunningSystem start(int thrusters) throws IOException {
    StringBuilder lines = new StringBuilder();
    for (int i = 1; i <= thrusters; i++) {
      lines.append(
          "  <service class=\"%s\" configuration=\"THRUSTER %d.xml\"/>%n"
              .formatted(ThrusterActuator.class.getName(), i));
    }
    Path file = directory.resolve("system.xml");
    Files.writeString(file, SYSTEM.formatted(Pilot.class.getName(), lines), UTF_8);
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(1)
            .logDirectory(directory)
            .override("CommunicationManager", "BROKER", "none")
            .making(Pilot.class, context -> new Pilot(context, run))
            .making(
                ThrusterActuator.class,
                context ->
                    new ThrusterActuator(
                        context,
                        propellers.get(context.configuration().getVariable("SERVICE NAME"))));
    return RunningSystem.start(SystemFile.read(file), options);
  }

  private void dive(double seconds) throws InterruptedException {
    for (double s = 0.0; s < seconds; s += 0.5) {
      clock.advance(Clock.micros(0.5));
    }
  }

  private double missM() {
    Point at = run.at(clock.micros()).position();
    return TARGET.distanceTo(Point.of(at.y(), at.x(), -at.z()));
  }

  private String log() throws IOException {
    return Files.readString(directory.resolve("Control.log"), UTF_8);
  }

  @Test
  void sixThrusters_oneWireBreaks_halfOfSurgeIsLeft() throws Exception {
    try (RunningSystem running = start(6)) {
      dive(20.0);
      assertThat(missM()).isLessThan(0.05);
      propellers.get("THRUSTER 1").plugged(false);
      dive(20.0);
      assertThat(missM()).isLessThan(0.05);
      assertThat(propellers.get("THRUSTER 7").percent()).isZero();
      assertThat(running.failed()).isEmpty();
    }
    assertThat(log()).contains("lost: THRUSTER 1; authority left: surge 50 %, sway 50 %, yaw 50 %");
  }

  @Test
  void seventhLineInTheSystemFile_isAllocatedToAndHealthSaysWhatItIsWorth() throws Exception {
    double most = 0.0;
    try (RunningSystem running = start(7)) {
      for (int i = 0; i < 40; i++) {
        dive(0.5);
        most = Math.max(most, Math.abs(propellers.get("THRUSTER 7").percent()));
      }
      assertThat(missM()).isLessThan(0.05);
      assertThat(most).as("the seventh thruster's command [%]").isGreaterThan(10.0);
      propellers.get("THRUSTER 1").plugged(false);
      dive(20.0);
      assertThat(missM()).isLessThan(0.05);
      assertThat(running.failed()).isEmpty();
    }
    // surge astern, the weaker way: 30 N (4 cos 45° + 1) had, 30 N (2 cos 45° + 1) left
    assertThat(log()).contains("lost: THRUSTER 1; authority left: surge 63 %, sway 43 %, yaw 43 %");
  }
}
