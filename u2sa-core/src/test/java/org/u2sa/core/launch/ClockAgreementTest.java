package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.directory.ClockAgreement;
import org.u2sa.testkit.FreePort;

/** Processes of one system whose machines' times of day differ. */
@Timeout(180)
class ClockAgreementTest {
  private static final long NOW = 1_700_000_000_000_000L;
  private static final long HOUR = 3_600_000_000L;

  private final List<String> log = new ArrayList<>();

  private static DiscoveryResponse answer(long micros) {
    DiscoveryResponse answer =
        new DiscoveryResponse()
            .serviceName("Throttle")
            .serviceType("ACTUATOR")
            .status(ServiceStatus.RUNNING)
            .host("hub")
            .version("1")
            .uptime(1.0);
    answer.timestamp(micros);
    return answer;
  }

  @Test
  void aheadMicros_severalAnswers_theSoonestCounts() {
    ClockAgreement agreement = new ClockAgreement(NOW);
    agreement.hear(answer(NOW + HOUR + 7_000), NOW + 10_000);
    agreement.hear(answer(NOW + HOUR + 100_000), NOW + 800_000); // waited on its way

    assertThat(agreement.aheadMicros(log::add)).isEqualTo(HOUR + 2_000);
    assertThat(log)
        .containsExactly(
            "this machine's clock is 3600.002 s behind the clock of Throttle on hub (± 0.005 s): "
                + "follows the system's time");
  }

  @Test
  void aheadMicros_liarAnswersFirst_theAnswerNearestToTheOwnClockCounts() {
    ClockAgreement agreement = new ClockAgreement(NOW);
    agreement.hear(answer(NOW - HOUR), NOW + 100);
    assertThat(agreement.isReached(NOW + 200)).isFalse();
    agreement.hear(answer(NOW + 10_000), NOW + 20_000);
    assertThat(agreement.isReached(NOW + 20_000)).isTrue();
    agreement.hear(answer(NOW - HOUR + 30_000), NOW + 30_000);

    assertThat(agreement.aheadMicros(log::add)).isZero();
    assertThat(log).isEmpty();
  }

  @Test
  void isReached_otherClock_waitsForOthersTwiceAsLongAsForTheFirstAnswer() {
    ClockAgreement near = new ClockAgreement(NOW);
    near.hear(answer(NOW + HOUR), NOW + 10_000);
    ClockAgreement far = new ClockAgreement(NOW);
    far.hear(answer(NOW + HOUR), NOW + 600_000);
    far.hear(answer(NOW + HOUR), NOW + 700_000);

    assertThat(near.isReached(NOW + 200_000)).isFalse();
    assertThat(near.isReached(NOW + 220_000)).isTrue();
    assertThat(far.isReached(NOW + 1_700_000)).isFalse();
    assertThat(far.isReached(NOW + 1_900_000)).isTrue();
    assertThat(new ClockAgreement(NOW).isReached(NOW + HOUR)).isFalse();
  }

  @Test
  void aheadMicros_withinToleranceOrError_isLeftAlone() {
    ClockAgreement near = new ClockAgreement(NOW);
    near.hear(answer(NOW + 90_000), NOW);
    ClockAgreement slow = new ClockAgreement(NOW);
    slow.hear(answer(NOW + 1), NOW + 900_000);

    assertThat(near.aheadMicros(log::add)).isZero();
    assertThat(slow.aheadMicros(log::add)).isZero();
    assertThat(new ClockAgreement(NOW).aheadMicros(log::add)).isZero();
    assertThat(log).isEmpty();
  }

  @Test
  void aheadMicros_answersInSimulatedOrAbsurdTime_isLeftAlone() {
    ClockAgreement agreement = new ClockAgreement(NOW);
    agreement.hear(answer(12_000_000L), NOW);
    agreement.hear(answer(9_223_372_036_854_000L), NOW);

    assertThat(agreement.aheadMicros(log::add)).isZero();
  }

  @Test
  void start_machineAnHourAhead_itsServicesGoByTheSystemsTime(@TempDir Path folder)
      throws IOException {
    int port = FreePort.find();
    Files.writeString(
        folder.resolve("Manager.xml"),
        "<configuration><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
            + port
            + "\"/></configuration>");
    SystemFile here = system(folder, RunningSystemTest.Quiet.class);
    SystemFile there = system(folder, Remote.class);
    SystemClock clock = new SystemClock();
    List<String> console = new CopyOnWriteArrayList<>();
    LaunchOptions wrong =
        new LaunchOptions()
            .logDirectory(folder.resolve("there"))
            .console(console::add)
            .clock(clock.ahead(HOUR))
            .oneOfSeveral(false)
            .override("CommunicationManager", "BROKER", "external");
    try (RunningSystem first =
            RunningSystem.start(here, new LaunchOptions().logDirectory(folder.resolve("here")));
        RunningSystem second = RunningSystem.start(there, wrong)) {
      assertThat(first.isRunning()).isTrue();
      Clock agreed = second.contextFor(XmlConfiguration.inMemory("test", Map.of())).clock();

      assertThat(Math.abs(agreed.micros() - clock.micros())).isLessThan(HOUR / 2);
      assertThat(console).anyMatch(line -> line.contains("this machine's clock is"));
    }
  }

  /** Another name than the first one's. */
  public static final class Remote extends EventDrivenService {
    public Remote(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Remote");
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  private static SystemFile system(Path folder, Class<?> service) throws IOException {
    return SystemFile.read(
        Files.writeString(
            folder.resolve(service.getSimpleName() + ".xml"),
            "<system id=\"boat\"><communication configuration=\"Manager.xml\"/><service class=\""
                + service.getName()
                + "\"/></system>"));
  }
}
