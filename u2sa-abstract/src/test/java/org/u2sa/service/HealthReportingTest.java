package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.testkit.ServiceKit;

/** What services say of themselves, and that a thread that just ends does not go unnoticed. */
@Timeout(120)
class HealthReportingTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();

  /** Publishes a state at each of its first steps. */
  private static final class Source extends PeriodicService {
    private int left;

    Source(ServiceContext context, int publications) {
      super(context, ServiceRole.STATE_ESTIMATOR, "Source", 10.0);
      left = publications;
      registerPublisher(StateInformation.class);
    }

    @Override
    protected void step(double nowS) {
      if (left-- > 0) {
        publish(new StateInformation().sensorName("a").x(nowS));
      }
    }
  }

  /** Its loop returns although it is to go on. */
  private static final class Careless extends U2SAService {
    Careless(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Careless");
    }

    @Override
    public void run() {
      try {
        sleep(500);
      } catch (InterruptedException e) {
        currentThread().interrupt();
      }
    }

    @Override
    public void kill() {
      running = false;
    }
  }

  private HealthReport last() {
    return kit.latest(Channels.HEALTH).orElseThrow();
  }

  @Test
  void report_serviceThatPublishes_countsItsDataAndTellsTheirAge() {
    kit.start(context -> new Source(context, 3));
    kit.advance(1.25);

    assertThat(last().published()).hasValue(3);
    assertThat(last().dataAge().orElseThrow()).isEqualTo(1.05); // the third came at 0.2 s
    assertThat(last().interval()).hasValue(0.25);
    assertThat(last().instance()).hasValueSatisfying(text -> assertThat(text).startsWith("local-"));
  }

  @Test
  void report_serviceThatOnlyAnswersRequests_hasNoData() {
    kit.start(context -> new Source(context, 0));
    kit.publish(Channels.DISCOVERY, new DiscoveryRequest());
    kit.advance(1.0);

    assertThat(last().published()).hasValue(0);
    assertThat(last().dataAge()).isEmpty();
  }

  @Test
  void run_returnsWhileRunning_timeGoesOnAndTheServiceIsReportedDead() throws Exception {
    Careless careless = kit.start(Careless::new);

    kit.advance(2.0);

    assertThat(kit.nowS()).isEqualTo(2.0);
    assertThat(careless.isRunning()).isFalse();
    assertThat(careless.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(last().status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(last().threadAlive()).hasValue(false);
    assertThat(last().lastError()).hasValueSatisfying(error -> assertThat(error).contains("run()"));
  }

  @Test
  void callback_error_lastReportSaysThatTheThreadIsDead() throws InterruptedException {
    PeriodicService victim =
        kit.start(
            context ->
                new PeriodicService(context, ServiceRole.OBSERVER, "Victim", 1.0) {
                  @Override
                  protected void step(double nowS) {
                    throw new AssertionError("broken");
                  }
                });
    victim.join();

    assertThat(last().threadAlive()).hasValue(false);
  }

  @Test
  void report_serviceThatEndsInGoodOrder_saysNothingOfItsThread() {
    kit.start(context -> new Source(context, 0)).kill();

    List<HealthReport> all = kit.published(Channels.HEALTH);
    assertThat(last().status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(all.stream().map(HealthReport::threadAlive).collect(Collectors.toList()))
        .allMatch(said -> said.isEmpty());
  }

  @Test
  void trouble_ofADevice_isInTheLogAndInTheReport() {
    Source source = kit.start(context -> new Source(context, 0));
    source.trouble("the compass is lost");
    kit.advance(0.25);

    assertThat(last().lastError()).hasValue("the compass is lost");
    assertThat(last().status()).isEqualTo(ServiceStatus.RUNNING);
    assertThat(last().exceptions()).isZero();
    assertThat(kit.log(source.getServiceName()))
        .anySatisfy(line -> assertThat(line).contains("WARN", "the compass is lost"));
  }

  @Test
  void overdueHealth_serviceThatReports_isEmpty() {
    Source source = kit.start(context -> new Source(context, 0));
    kit.advance(3.1);
    assertThat(source.overdueHealth()).isEmpty();

    source.kill();
    assertThat(source.overdueHealth()).isEmpty();
  }
}
