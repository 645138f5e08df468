package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

@Timeout(120)
class ServiceLifeTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();

  /** Notes what it is handed, and fails when it is told to. */
  private static class Listener extends EventDrivenService {
    private final List<U2SAData> received = new ArrayList<>();
    private final List<Thread> threads = new ArrayList<>(); // as which it ran
    private final List<Thread> takers = new ArrayList<>(); // on which it ran
    private int released;
    private boolean failing;

    Listener(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Listener");
      registerSubscriber(StateInformation.class);
    }

    @Override
    public void callback(U2SAData data) {
      received.add(data);
      threads.add(Clock.runningThread());
      takers.add(Thread.currentThread());
      if (failing) {
        throw new IllegalStateException("told to fail");
      }
    }

    @Override
    protected void release() {
      released++;
    }
  }

  /** Counts its steps. */
  private static final class Stepper extends PeriodicService {
    private final List<Double> steps = new ArrayList<>();

    Stepper(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Stepper", 10.0);
    }

    @Override
    protected void step(double nowS) {
      steps.add(nowS);
    }
  }

  /** Fails in each step. */
  private static final class Vital extends PeriodicService {
    private int steps;

    Vital(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Vital", 10.0);
      failAtFirstError();
      subscribe(Channels.STATE, this::refuse);
    }

    private void refuse(StateInformation state) {
      throw new IllegalStateException("told to fail");
    }

    @Override
    protected void step(double nowS) {
      if (++steps == 3) {
        throw new IllegalStateException("told to fail");
      }
    }
  }

  @Test
  void step_thatThrowsOfAServiceThatMustNotMissAny_isAFailureAtOnce() {
    Vital vital = kit.start(Vital::new);

    kit.publish(Channels.STATE, state("a"));
    kit.advance(0.15);
    assertThat(vital.status()).isEqualTo(ServiceStatus.RUNNING);
    kit.advance(0.1);

    assertThat(vital.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(vital.steps).isEqualTo(3);
    assertThat(kit.log("Vital")).anyMatch(line -> line.endsWith("stopping after an exception"));
  }

  @Test
  void step_thatAlwaysThrows_isAFailureAlsoBetweenMessagesThatAreHandled() {
    PeriodicService useless =
        kit.with("MAX ERRORS IN A ROW", 3)
            .start(
                context ->
                    new PeriodicService(context, ServiceRole.OBSERVER, "Useless", 10.0) {
                      {
                        subscribe(Channels.STATE, state -> {});
                      }

                      @Override
                      protected void step(double nowS) {
                        throw new IllegalStateException("told to fail");
                      }
                    });

    for (int i = 0; i < 4; i++) {
      kit.publish(Channels.STATE, state("a"));
      kit.advance(0.1);
    }

    assertThat(useless.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(kit.log("Useless"))
        .anyMatch(line -> line.endsWith("stopping after 3 consecutive steps that threw"));
  }

  private static StateInformation state(String sensor) {
    return new StateInformation().sensorName(sensor).x(1.0);
  }

  @Test
  void callback_message_isHandedOverAsTheServicesThread() {
    Listener listener = kit.start(Listener::new);

    kit.publish(Channels.STATE, state("a"));

    assertThat(listener.received).hasSize(1);
    assertThat(listener.threads).containsExactly(listener);
    assertThat(listener.takers).doesNotContain(listener); // so no thread is woken for it
  }

  @Test
  void keepToOwnThread_messagesAndSteps_areHandledOnNoOtherThread() {
    List<Thread> takers = new ArrayList<>();
    class Bound extends PeriodicService {
      Bound(ServiceContext context) {
        super(context, ServiceRole.OBSERVER, "Bound", 10.0);
        keepToOwnThread();
        subscribe(Channels.STATE, state -> takers.add(Thread.currentThread()));
      }

      @Override
      protected void step(double nowS) {
        takers.add(Thread.currentThread());
      }
    }
    Bound bound = kit.start(Bound::new);

    kit.publish(Channels.STATE, state("a"));
    kit.advance(0.2);

    assertThat(takers).hasSize(4).containsOnly(bound);
  }

  @Test
  void log_inATurnThatTheClockTakes_saysTheServicesThread() {
    Listener listener =
        kit.start(
            context ->
                new Listener(context) {
                  @Override
                  public void callback(U2SAData data) {
                    super.callback(data);
                    log("heard");
                  }
                });

    kit.publish(Channels.STATE, state("a"));

    assertThat(kit.log("Listener"))
        .filteredOn(line -> line.endsWith("heard"))
        .hasSize(1)
        .allMatch(line -> line.contains(" " + listener.getThreadID() + " "));
  }

  @Test
  void kill_fromItsOwnHandler_endsAfterTheHandlerAndDoesNotWaitForItself() {
    List<Integer> releasedThen = new ArrayList<>();
    Listener listener =
        kit.start(
            context ->
                new Listener(context) {
                  @Override
                  public void callback(U2SAData data) {
                    kill();
                    releasedThen.add(super.released);
                  }
                });

    kit.publish(Channels.STATE, state("a"));
    listener.kill(); // waits for the end

    assertThat(releasedThen).containsExactly(0);
    assertThat(listener.released).isEqualTo(1);
  }

  @Test
  void callback_severalStatesOfOneSourceWaiting_onlyTheNewestComesAndTheRestIsCounted() {
    Listener listener = kit.start(Listener::new);
    StateInformation newest = state("a");

    kit.send(Channels.STATE, state("a"));
    kit.send(Channels.STATE, state("b"));
    kit.send(Channels.STATE, newest);
    kit.advance(1.0);

    assertThat(listener.received).hasSize(2).first().isSameAs(newest);
    HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
    assertThat(health.replaced()).hasValue(1);
    assertThat(health.dropped()).isZero(); // a newer one came: nothing was lost
  }

  @Test
  void callback_moreWaitThanTheInboxHolds_whatIsLostCountsAsDroppedOnly() {
    kit.with("INBOX CAPACITY", 1);
    kit.start(Listener::new);

    kit.send(Channels.STATE, state("a"));
    kit.send(Channels.STATE, state("b"));
    kit.advance(1.0);

    HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
    assertThat(health.dropped()).isEqualTo(1);
    assertThat(health.replaced()).hasValue(0);
  }

  @Test
  void callback_throwsTooOftenInARow_serviceKillsItselfAndSaysSo() {
    kit.with("MAX ERRORS IN A ROW", 3);
    Listener listener = kit.start(Listener::new);
    listener.failing = true;

    for (int i = 0; i < 5; i++) {
      kit.publish(Channels.STATE, state("a"));
    }

    assertThat(listener.received).hasSize(3);
    assertThat(listener.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(listener.released).isEqualTo(1);
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(kit.log("Listener"))
        .anyMatch(line -> line.contains("stopping after 3 consecutive exceptions"));
  }

  @Test
  void step_atItsRate_isCalledOnAFixedGrid() {
    Stepper stepper = kit.start(Stepper::new);

    kit.advance(0.35);

    assertThat(stepper.steps).containsExactly(0.0, 0.1, 0.2, 0.3);
  }

  @Test
  void rate_fromConfiguration_isObeyed() {
    Stepper stepper = kit.with("RATE", 50.0).start(Stepper::new);

    kit.advance(0.05);

    assertThat(stepper.steps).containsExactly(0.0, 0.02, 0.04);
  }

  @Test
  void stopCommand_byName_endsThatServiceOnly() throws InterruptedException {
    Listener listener = kit.start(Listener::new);
    Stepper stepper = kit.start(Stepper::new);

    kit.publish(Channels.STOP, new StopCommand().serviceName("Listener"));
    listener.join();

    assertThat(listener.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(listener.released).isEqualTo(1);
    assertThat(stepper.isRunning()).isTrue();
  }

  @Test
  void stopCommand_all_endsEveryService() throws InterruptedException {
    Listener listener = kit.start(Listener::new);
    Stepper stepper = kit.start(Stepper::new);

    kit.publish(Channels.STOP, new StopCommand().stopAll(true));
    listener.join();
    stepper.join();

    assertThat(listener.isRunning()).isFalse();
    assertThat(stepper.isRunning()).isFalse();
  }

  /** A broker keeps orders while a link is down. */
  @Test
  void stopCommand_olderThanOrderExpiry_endsNothing() throws InterruptedException {
    Listener listener = kit.start(Listener::new);
    StopCommand late = new StopCommand().stopAll(true);
    late.timestamp(kit.clock().micros() - Clock.micros(20.0));
    kit.publish(Channels.STOP, late);

    assertThat(listener.isRunning()).isTrue();
    assertThat(kit.log("Listener"))
        .anyMatch(line -> line.contains("not stopped, because the order arrived 20.0 s"));
    StopCommand inTime = new StopCommand().stopAll(true);
    inTime.timestamp(kit.clock().micros() - Clock.micros(4.0));
    kit.publish(Channels.STOP, inTime);
    listener.join();
    assertThat(listener.isRunning()).isFalse();
  }

  @Test
  void kill_twiceAndFromAnotherThread_releasesOnce() {
    Listener listener = kit.start(Listener::new);

    listener.kill();
    listener.kill();

    assertThat(listener.released).isEqualTo(1);
    assertThat(listener.isAlive()).isFalse();
    assertThat(listener.status()).isEqualTo(ServiceStatus.STOPPED);
  }

  @Test
  void kill_neverStarted_releases() {
    Listener listener = new Listener(kit.context());

    listener.kill();

    assertThat(listener.released).isEqualTo(1);
  }

  @Test
  void start_unknownVariable_isRefusedBeforeTheThreadRuns() {
    Listener listener = new Listener(kit.with("INBOX CAPACTIY", 5).context());

    assertThatThrownBy(listener::start)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("INBOX CAPACTIY")
        .hasMessageContaining("INBOX CAPACITY");
    assertThat(listener.isRunning()).isFalse();
    listener.kill();
  }

  @Test
  void construction_variableOutOfRange_isRefusedByName() {
    kit.with("MAX ERRORS IN A ROW", 0);

    assertThatThrownBy(() -> new Listener(kit.context()))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("MAX ERRORS IN A ROW");
  }

  @Test
  void health_isReportedAtTheIntervalWithoutALineInTheSubclass() {
    kit.with("HEALTH INTERVAL", 0.5).start(Listener::new);

    kit.advance(1.2);

    assertThat(kit.published(Channels.HEALTH))
        .hasSize(3)
        .allMatch(report -> report.status() == ServiceStatus.RUNNING);
  }
}
