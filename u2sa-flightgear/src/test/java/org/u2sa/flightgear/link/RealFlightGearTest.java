package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.flightgear.protocol.ProtocolFiles;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.Repository;

/** The link against the installed FlightGear: {@code mvn verify -Pflightgear}, half a minute. */
@Tag("flightgear")
final class RealFlightGearTest {
  private static final ControlInputs FULL_THROTTLE = ControlInputs.neutral().withThrottle(1.0);
  private static final int START_S = 180;

  private final Clock clock = new SystemClock();
  private final StringBuilder troubles = new StringBuilder();
  @TempDir private Path data;
  private FlightGearLink link;
  private int inPort;
  private int propertyPort;

  @BeforeEach
  void start() throws Exception {
    ProtocolFiles.writeTo(data);
    inPort = FreePort.find();
    propertyPort = FreePort.find();
    link = new FlightGearLink("127.0.0.1", 0, inPort, propertyPort, clock);
    script(
        "start",
        "--data-dir",
        data.toString(),
        "--out-port",
        String.valueOf(link.outPort()),
        "--in-port",
        String.valueOf(inPort),
        "--props-port",
        String.valueOf(propertyPort));
  }

  @AfterEach
  void stop() throws Exception {
    link.close();
    script("stop", "--in-port", String.valueOf(inPort));
  }

  @Test
  void takeOffRun_linkCutBothWays_isMendedAndTheAircraftObeys() throws Exception {
    AircraftReading parked = readUntil(AircraftReading::connected);
    assertThat(parked.state().heightAboveGround().orElse(0.0)).isBetween(-0.1, 0.1);
    assertThat(parked.state().x().orElse(0.0)).isBetween(-157.9433, -157.9431);
    assertThat(parked.state().y().orElse(0.0)).isBetween(21.3252, 21.3253);
    assertThat(parked.state().psi().orElse(0.0)).isBetween(1.55, 1.58);
    assertThat(parked.state().engineStarting()).isTrue();

    // Somebody spoils the channel for controls; full throttle would kill the engine while it
    // starts, were it not held back.
    try (Socket somebody = new Socket(InetAddress.getLoopbackAddress(), inPort)) {
      somebody.getOutputStream().write("0,0,0,0,0.3\n0.5,0".getBytes(StandardCharsets.US_ASCII));
    }
    link.write(FULL_THROTTLE);
    awaitTrouble("FlightGear does not accept controls");
    awaitTrouble("FlightGear accepts controls again");
    AircraftReading running = readUntil(each -> !each.state().engineStarting());
    assertThat(running.state().engineRpm().orElse(0.0)).isGreaterThan(600.0);
    AircraftReading rolling =
        readUntil(each -> each.state().calibratedAirspeed().orElse(0.0) > 8.0);
    assertThat(rolling.state().fluidxDot().orElse(0.0)).isBetween(7.5, 9.0);
    assertThat(rolling.state().engineRpm().orElse(0.0)).isGreaterThan(2_000.0);

    try (PropertyServer server = new PropertyServer("127.0.0.1", propertyPort)) {
      assertThat(server.run("remove-io-channel name=generic-1")).isTrue();
    }
    readUntil(each -> !each.connected());
    AircraftReading back = readUntil(AircraftReading::connected);
    assertThat(back.state().calibratedAirspeed().orElse(0.0))
        .isGreaterThan(rolling.state().calibratedAirspeed().orElse(0.0));
    link.write(ControlInputs.neutral().withBrakes(1.0, 1.0));
    readUntil(each -> each.state().calibratedAirspeed().orElse(0.0) < 2.0);
    awaitTrouble("asked FlightGear to restore the link");
  }

  private AircraftReading readUntil(Predicate<AircraftReading> condition) {
    return patiently().until(() -> link.read(clock.micros()), condition);
  }

  private void awaitTrouble(String part) {
    patiently().until(() -> troubles.append(link.trouble()).append('\n').indexOf(part) >= 0);
  }

  private static ConditionFactory patiently() {
    return await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(5))
        .atMost(Duration.ofSeconds(40));
  }

  private void script(String name, String... arguments) throws Exception {
    List<String> command =
        new ArrayList<>(
            List.of(Repository.root().resolve("scripts/flightgear").resolve(name).toString()));
    command.addAll(List.of(arguments));
    Path output = data.resolve(name + ".txt");
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor(START_S, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).as(Files.readString(output)).isZero();
  }
}
