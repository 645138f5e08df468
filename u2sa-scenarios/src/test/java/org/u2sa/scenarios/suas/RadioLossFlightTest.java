package org.u2sa.scenarios.suas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.safety.OperatorHeartbeat;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.testkit.Repository;
import org.u2sa.trials.run.RunPlans;
import org.u2sa.trials.run.VehicleTrial;

/** The plane of the competition, in flight, loses its pilot's radio. */
class RadioLossFlightTest {
  private static final double AUTOMATIC_S = 0.002;
  private static final double MANUAL_S = 0.001;
  private static final double NONE = 0.0;

  @TempDir private Path folder;
  private final LockstepClock clock = new LockstepClock();
  private double switchS = AUTOMATIC_S;
  private VehicleTrial plane;
  private RunningSystem running;
  private Station station;

  /** Hears the vehicle; sends heartbeats while the operator is there. */
  private static final class Station extends PeriodicService {
    private final List<ManualState> manual = new ArrayList<>();
    private FailsafeState failsafe;
    private int commands; // of the aileron
    private boolean isThere = true;

    Station(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Station", 1.0);
      registerPublisher(Channels.OPERATOR);
      registerSubscriber(Channels.MANUAL_STATE);
      registerSubscriber(Channels.FAILSAFE);
      registerSubscriber(Channels.ACTUATION);
    }

    @Override
    protected void step(double nowS) {
      if (isThere) {
        publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann").interval(1.0));
      }
    }

    @Override
    public void callback(U2SAData data) {
      if (data instanceof ManualState state) {
        manual.add(state);
      } else if (data instanceof FailsafeState state) {
        failsafe = state;
      } else if (data instanceof ActuatorCommand command) {
        commands += command.actuatorName().equals("AILERON") ? 1 : 0;
      }
    }

    boolean isByHand() {
      return !manual.isEmpty() && manual.get(manual.size() - 1).active();
    }
  }

  private record Devices(ServiceContext.DeviceSource vehicle, RadioReceiver radio)
      implements ServiceContext.DeviceSource {
    @Override
    public <D> Optional<D> device(
        Class<D> port, String service, XmlConfiguration variables, Clock time) {
      return port == RadioReceiver.class
          ? Optional.of(port.cast(radio))
          : vehicle.device(port, service, variables, time);
    }
  }

  @BeforeEach
  void flyToTheFirstWaypoint() throws IOException, InterruptedException {
    System.setProperty("u2sa.home", Repository.root().toString());
    Path own = Repository.root().resolve("config/suas/plane");
    Path system = folder.resolve("system.xml");
    Files.writeString(
        system,
        Files.readString(own.resolve("system-competition.xml"))
            .replaceFirst("<service class=\"[^\"]*SurveyCamera\"[^>]*>", "")
            .replace("configuration=\"", "configuration=\"" + own + "/"));
    Path file = folder.resolve("mission.xml");
    Files.writeString(
        file,
        "<mission><home><x>-76.55578</x><y>38.31633</y><z>43.28</z><psi>0</psi></home>"
            + "<takeOff><z>103</z></takeOff>"
            + "<waypoint><x>-76.55578</x><y>38.32083</y><z>123</z></waypoint>"
            + "<waypoint><x>-76.55578</x><y>38.36633</y><z>123</z></waypoint></mission>");
    RunPlan.Start start = RunPlans.start(Mission.load(file));
    plane =
        VehicleTrial.of(
            VehicleFile.load(own.resolve("vehicle.xml"), Map.of()),
            VehicleTrial.at(start),
            Point.ORIGIN,
            start.headingRad(),
            3);
    RadioReceiver radio =
        nowMicros ->
            switchS == NONE
                ? Optional.empty()
                : Optional.of(
                    new RadioReceiver.Pulses(
                        nowMicros, List.of(0.0015, 0.0015, 0.0015, 0.0015, switchS)));
    LaunchOptions options =
        new LaunchOptions()
            .clock(clock)
            .seed(3)
            .logDirectory(folder)
            .override("CommunicationManager", "BROKER", "none")
            .override("MissionManager", "MISSION", file.toString())
            .override("SafetyManager", "OPERATOR DEADLINE", 5.0)
            .devices(new Devices(plane.devices(), radio));
    running = RunningSystem.start(SystemFile.read(system), options);
    station = new Station(running.contextFor(XmlConfiguration.inMemory("Station", Map.of())));
    station.start();
    fly(45.0);
    assertThat(heightM()).isGreaterThan(50.0);
    assertThat(station.failsafe.causes()).isEmpty();
  }

  @AfterEach
  void close() {
    station.kill();
    running.close();
  }

  private void fly(double seconds) throws InterruptedException {
    clock.advance(Clock.micros(seconds));
  }

  private double heightM() {
    return plane.run().at(clock.micros()).position().z();
  }

  @Test
  void radioLost_switchAtAutomatic_fliesOnUnderItsFailsafesAndIsTakenOverAtTheReturn()
      throws InterruptedException {
    switchS = NONE;
    fly(15.0);
    assertThat(station.isByHand()).isFalse();
    assertThat(heightM()).isBetween(65.0, 90.0);
    assertThat(station.failsafe.action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(station.failsafe.causes())
        .containsExactly("pilot's radio: lost: automatic control continues");

    station.isThere = false;
    fly(10.0);
    assertThat(station.failsafe.action()).isEqualTo(FailsafeAction.RETURN);

    switchS = MANUAL_S;
    fly(0.3);
    assertThat(station.isByHand()).isTrue();
    int commands = station.commands;
    fly(1.0);
    assertThat(station.commands).isEqualTo(commands);
  }

  @Test
  void radiosServiceEnds_switchAtManual_fliesOnAndReturns() throws InterruptedException {
    switchS = MANUAL_S;
    fly(0.5);
    assertThat(station.isByHand()).isTrue();
    station.isThere = false;
    running.services().stream()
        .filter(each -> each.getServiceName().equals("RadioSensor"))
        .forEach(U2SAService::kill);
    fly(15.0);

    assertThat(station.isByHand()).isFalse();
    assertThat(station.failsafe.action()).isEqualTo(FailsafeAction.RETURN);
    double heightM = heightM(); // that at the beginning of the return, less than before
    fly(15.0);
    assertThat(heightM()).isCloseTo(heightM, within(3.0)).isGreaterThan(30.0);
  }

  @Test
  void radioLost_switchAtManual_controlStaysWithheldAndIsTakenUpWhenGivenBack()
      throws InterruptedException {
    switchS = MANUAL_S;
    fly(0.3);
    station.isThere = false;
    switchS = NONE;
    int commands = station.commands;
    fly(6.5);
    assertThat(station.isByHand()).isTrue();
    assertThat(station.commands).isEqualTo(commands);
    assertThat(station.failsafe.action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(station.failsafe.causes())
        .contains("pilot's radio: lost: control stays with the pilot")
        .anyMatch(cause -> cause.startsWith("operator link: "));

    switchS = AUTOMATIC_S;
    fly(1.0);
    assertThat(station.isByHand()).isFalse();
    assertThat(station.commands).isGreaterThan(commands);
    assertThat(station.failsafe.action()).isEqualTo(FailsafeAction.CONTINUE);
  }
}
