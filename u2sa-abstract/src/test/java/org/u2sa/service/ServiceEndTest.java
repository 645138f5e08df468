package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** How services end when things go wrong, or at a bad moment. */
@Timeout(120)
class ServiceEndTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();

  /** Fails as it is told to. */
  private static final class Victim extends EventDrivenService {
    private final List<U2SAData> received = new ArrayList<>();
    private Throwable inCallback;
    private Throwable inRelease;
    private boolean began;
    private int released;

    Victim(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Victim");
      registerSubscriber(StateInformation.class);
    }

    @Override
    protected void begin() {
      began = true;
    }

    @Override
    public void callback(U2SAData data) {
      received.add(data);
      Victim.<RuntimeException>fail(inCallback);
    }

    @Override
    protected void release() {
      released++;
      Victim.<RuntimeException>fail(inRelease);
    }

    /** Throws anything without declaring it, as Kotlin's functions may. */
    @SuppressWarnings("unchecked")
    private static <T extends Throwable> void fail(Throwable what) throws T {
      if (what != null) {
        throw (T) what;
      }
    }
  }

  private static StateInformation state() {
    return new StateInformation().sensorName("a").x(1.0);
  }

  @Test
  void callback_error_serviceFailsAndLogAndHealthSayWhy() throws InterruptedException {
    Victim victim = kit.start(Victim::new);
    victim.inCallback = new AssertionError("broken beyond repair");

    kit.publish(Channels.STATE, state());
    victim.join();

    assertThat(victim.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(victim.released).isEqualTo(1);
    HealthReport last = kit.latest(Channels.HEALTH).orElseThrow();
    assertThat(last.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(last.lastError())
        .hasValueSatisfying(error -> assertThat(error).contains("broken beyond repair"));
    assertThat(kit.log("Victim")).anyMatch(line -> line.contains("broken beyond repair"));
  }

  @Test
  void callback_undeclaredCheckedException_isSurvivedLoggedAndReported() {
    Victim victim = kit.start(Victim::new);
    victim.inCallback = new IOException("device gone");
    kit.publish(Channels.STATE, state());
    kit.publish(Channels.STATE, state());
    kit.advance(1.0);

    assertThat(victim.received).hasSize(2);
    assertThat(victim.isRunning()).isTrue();
    HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
    assertThat(health.exceptions()).isEqualTo(2);
    assertThat(health.lastError()).contains("java.io.IOException: device gone");
    assertThat(kit.log("Victim"))
        .anyMatch(line -> line.contains("ERROR") && line.contains("device gone"))
        .anyMatch(line -> line.contains("at org.u2sa.service.ServiceEnd"));
  }

  @Test
  void release_error_closesTheRestAndTimeGoesOn() throws InterruptedException {
    Victim victim = kit.start(Victim::new);
    victim.inRelease = new AssertionError("cannot let go");

    kit.publish(Channels.STOP, new StopCommand().serviceName("Victim"));
    victim.join();
    kit.advance(1.0);

    assertThat(kit.nowS()).isEqualTo(1.0);
    assertThat(kit.log("Victim")).anyMatch(line -> line.contains("cannot let go"));
    assertThat(kit.start(Victim::new).isRunning()).isTrue(); // its name is free again
  }

  @Test
  void release_errorThatCannotBeLogged_stillLetsGoOfItsName() throws InterruptedException {
    Victim victim = kit.start(Victim::new);
    victim.inRelease =
        new AssertionError("cannot let go") {
          private static final long serialVersionUID = 1L;

          @Override
          public String toString() {
            throw new OutOfMemoryError("heap");
          }
        };

    kit.publish(Channels.STOP, new StopCommand().serviceName("Victim"));
    victim.join();

    assertThat(kit.start(Victim::new).isRunning()).isTrue();
  }

  @Test
  void stopCommand_beforeStart_endsItWithoutRunning() throws InterruptedException {
    Victim victim = new Victim(kit.context());
    kit.publish(Channels.STOP, new StopCommand().stopAll(true));

    victim.start();
    kit.settle();
    victim.join();

    assertThat(victim.began).isFalse();
    assertThat(victim.isRunning()).isFalse();
    assertThat(victim.status()).isEqualTo(ServiceStatus.STOPPED);
    assertThat(victim.released).isEqualTo(1);
  }

  @Test
  void start_afterKill_isRefused() {
    Victim victim = new Victim(kit.context());
    victim.kill();

    assertThatThrownBy(victim::start)
        .isInstanceOf(IllegalThreadStateException.class)
        .hasMessageContaining("Victim");
    assertThat(victim.isRunning()).isFalse();
    assertThat(victim.status()).isEqualTo(ServiceStatus.STOPPED);
  }

  @Test
  void start_twice_isRefusedAndTheServiceGoesOn() {
    Victim victim = kit.start(Victim::new);

    assertThatThrownBy(victim::start).isInstanceOf(IllegalThreadStateException.class);
    kit.publish(Channels.STATE, state());

    assertThat(victim.received).hasSize(1);
  }

  @Test
  void kill_fromAnotherServicesCallback_endsItAndTimeGoesOn() {
    Victim victim = kit.start(Victim::new);
    kit.start(
        context ->
            new PeriodicService(context, ServiceRole.OBSERVER, "Killer", 1.0) {
              @Override
              protected void step(double nowS) {
                if (nowS > 0.0) {
                  victim.kill();
                }
              }
            });

    kit.advance(3.0);

    assertThat(victim.isAlive()).isFalse();
    assertThat(victim.released).isEqualTo(1);
    assertThat(kit.nowS()).isEqualTo(3.0);
  }

  /** Does not come to life: its own variable is wrong, which it learns last. */
  private static final class Stillborn extends EventDrivenService {
    Stillborn(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Stillborn");
      throw new IllegalStateException("no device");
    }
  }

  @Test
  void abandon_constructionFailed_freesTheNameAndClosesTheLog() {
    ServiceContext context = kit.context();
    assertThatThrownBy(() -> new Stillborn(context)).hasMessage("no device");

    context.abandon();

    assertThatThrownBy(() -> new Stillborn(kit.context())).hasMessage("no device");
  }

  /** Its run returns at once, and it has no messages to handle. */
  private static final class Careless extends U2SAService {
    Careless(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Careless");
    }

    @Override
    public void run() {
      log("returns at once");
    }

    @Override
    public void kill() {
      running = false;
    }
  }

  @Test
  void run_returnsWithoutAnythingLeftToDo_serviceFailsAndTimeGoesOn() {
    Careless careless = kit.start(Careless::new);

    kit.advance(10.0); // hangs for ever if the thread that is gone still has a place in the clock

    assertThat(kit.nowS()).isEqualTo(10.0);
    assertThat(careless.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(kit.log("Careless")).anyMatch(line -> line.contains("run() returned while running"));
  }
}
