package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.function.Predicate;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.testkit.FreePort;

/** A link that was cut comes back over the property server. */
final class FlightGearRepairTest {
  private final Clock clock = new SystemClock();
  private final StringBuilder troubles = new StringBuilder();
  private StandInFlightGear standIn;
  private FlightGearLink link;

  @BeforeEach
  void open() throws IOException {
    standIn =
        new StandInFlightGear(
            AircraftLinkContract.parkedAircraft(),
            StandInSetup.ready(100.0, 1.0),
            "127.0.0.1",
            0,
            0,
            clock);
    link = new FlightGearLink("127.0.0.1", 0, standIn.inPort(), standIn.propertyPort(), clock);
  }

  @AfterEach
  void close() {
    link.close();
    standIn.close();
  }

  @Test
  void linesCut_flightGearIsAskedToConnectAgain() throws IOException {
    fly();
    command("remove-io-channel name=generic-1");
    readUntil(each -> !each.connected());
    AircraftReading back = readUntil(AircraftReading::connected);
    assertThat(clock.micros() - back.measuredAtMicros()).isLessThan(500_000);
    awaitTrouble("asked FlightGear to restore the link");
    assertThat(troubles.toString())
        .contains("FlightGear closed the connection of its lines", "FlightGear is connected again");
    link.write(throttle(0.7));
    awaitThrottle(0.7);
  }

  @Test
  void linkIsStartedAfterFlightGear_flightGearIsAskedToConnect() throws IOException {
    standIn.start("127.0.0.1", FreePort.find());
    readUntil(AircraftReading::connected);
    link.write(throttle(0.7));
    awaitThrottle(0.7);
  }

  @Test
  void controlChannelRemoved_flightGearIsAskedToListenAgain() throws IOException {
    fly();
    command("remove-io-channel name=generic-2");
    awaitTrouble("controls do not reach FlightGear");
    awaitTrouble("FlightGear accepts controls again");
    link.write(throttle(0.7));
    awaitThrottle(0.7);
    assertThat(link.read(clock.micros()).connected()).isTrue();
  }

  @Test
  void somebodyLeftInTheMiddleOfALine_deafFlightGearIsNoticedAndRepaired() throws IOException {
    standIn.start("127.0.0.1", link.outPort());
    readUntil(AircraftReading::connected);
    deafen(0.25);
    link.write(throttle(0.7));
    awaitTrouble("FlightGear does not accept controls");
    awaitThrottle(0.7);
  }

  @Test
  void linkOfAnotherProcessAfterRepairs_findsTheChannelsThatTheFirstOneLeft() throws IOException {
    fly();
    command("remove-io-channel name=generic-1");
    awaitTrouble("FlightGear is connected again");
    command("remove-io-channel name=generic-2");
    awaitTrouble("FlightGear accepts controls again");
    link.write(throttle(0.7));
    awaitThrottle(0.7);
    link.close();
    deafen(0.5);

    link = new FlightGearLink("127.0.0.1", 0, standIn.inPort(), standIn.propertyPort(), clock);
    readUntil(AircraftReading::connected);
    link.write(throttle(0.3));

    awaitThrottle(0.3);
  }

  private void deafen(double aileron) throws IOException {
    try (Socket somebody = new Socket(InetAddress.getLoopbackAddress(), standIn.inPort())) {
      somebody.getOutputStream().write((aileron + "\n0.5,0").getBytes(StandardCharsets.US_ASCII));
    }
    quickly().until(() -> standIn.told().controls().aileron() == aileron);
  }

  @Test
  void flightGearGoneForGood_isSaidOnceAndReadingAndWritingGoOn() throws IOException {
    fly();
    int propertyPort = standIn.propertyPort();
    standIn.close();
    readUntil(each -> !each.connected());
    link.write(throttle(0.7));
    awaitTrouble(
        "FlightGear cannot be asked to restore the link: property server 127.0.0.1:"
            + propertyPort);
    assertThat(link.read(clock.micros()).sequence()).isPositive();
  }

  private void fly() {
    standIn.start("127.0.0.1", link.outPort());
    readUntil(AircraftReading::connected);
    link.write(throttle(0.2));
    awaitThrottle(0.2);
  }

  private void command(String command) throws IOException {
    try (PropertyServer server = new PropertyServer("127.0.0.1", standIn.propertyPort())) {
      assertThat(server.run(command)).isTrue();
    }
  }

  private static ControlInputs throttle(double throttle) {
    return ControlInputs.neutral().withThrottle(throttle);
  }

  private void awaitThrottle(double throttle) {
    quickly().until(() -> standIn.told().controls().throttle() == throttle);
  }

  private AircraftReading readUntil(Predicate<AircraftReading> condition) {
    return quickly().until(() -> link.read(clock.micros()), condition);
  }

  private void awaitTrouble(String part) {
    quickly().until(() -> troubles.append(link.trouble()).append('\n').indexOf(part) >= 0);
  }

  private static ConditionFactory quickly() {
    return await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(2))
        .atMost(Duration.ofSeconds(60));
  }
}
