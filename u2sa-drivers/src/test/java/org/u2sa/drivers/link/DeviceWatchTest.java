package org.u2sa.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.DeviceWatch;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/** A service's log and health report tell when its device goes and comes. */
class DeviceWatchTest {
  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();
  private Listener listener;

  /** Counts each byte "a" as readable, each other one as malformed. */
  private static final class Listener extends ExteroceptiveSensor {
    private final ByteLink link;
    private final DeviceWatch watch;
    private long malformed;
    private int found;

    Listener(ServiceContext context, ByteLink link) {
      super(context, "Listener", 10.0);
      this.link = link;
      this.watch = new DeviceWatch(this, "the sonar", link, 1.0);
    }

    @Override
    protected void step(double nowS) {
      long now = clock().micros();
      found += watch.look(now) ? 1 : 0;
      byte[] buffer = new byte[64];
      int count = link.read(buffer);
      for (int i = 0; i < count; i++) {
        if (buffer[i] == 'a') {
          watch.heard(now);
        } else {
          watch.malformed(++malformed, "noise");
        }
      }
    }
  }

  @BeforeEach
  void start() {
    link.fromDevice((byte) 'a');
    listener = kit.start(context -> new Listener(context, link));
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private Optional<String> lastError() {
    kit.advance(0.5);
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError);
  }

  private boolean isHeard() {
    return listener.watch.isHeard(kit.clock().micros());
  }

  @Test
  void look_deviceUnpluggedAndPlugged_isSaidAndFoundAnew() {
    assertThat(listener.found).isEqualTo(1);
    assertThat(isHeard()).isTrue();

    link.unplug();
    assertThat(lastError()).hasValue("the sonar is lost: unplugged");
    assertThat(isHeard()).isFalse();

    link.plug();
    kit.advance(0.1);
    assertThat(listener.found).isEqualTo(2);
    assertThat(isHeard()).as("not before it says something").isFalse();
    link.fromDevice((byte) 'a');
    kit.advance(0.1);
    assertThat(isHeard()).isTrue();
    assertThat(kit.log("Listener"))
        .anySatisfy(line -> assertThat(line).contains("INFO", "the sonar is connected"));
  }

  @Test
  void look_silentDevice_isSaidOnceAndWhenItSpeaksAgain() {
    kit.advance(2.0);
    assertThat(lastError()).hasValue("the sonar has sent no valid data for more than 1.0 s");
    link.fromDevice((byte) 'a');
    kit.advance(0.2);
    List<String> log = kit.log("Listener");
    assertThat(log.stream().filter(line -> line.contains("sent no valid data"))).hasSize(1);
    assertThat(log).anySatisfy(line -> assertThat(line).contains("the sonar sends again"));
  }

  @Test
  void look_deviceThatIsFoundSoonAfterTheStart_isNoTrouble() {
    MemoryLink late = new MemoryLink();
    late.unplug();
    kit.with("SERVICE NAME", "Late");
    kit.start(context -> new Listener(context, late));
    kit.advance(1.5);
    assertThat(kit.log("Late")).noneMatch(line -> line.contains("WARN"));
    late.plug();
    kit.advance(0.2);
    assertThat(kit.log("Late")).anyMatch(line -> line.contains("the sonar is connected"));
  }

  @Test
  void look_deviceThatIsNotFound_isSaid() {
    MemoryLink absent = new MemoryLink();
    absent.unplug();
    kit.with("SERVICE NAME", "Lonely");
    kit.start(context -> new Listener(context, absent));
    kit.advance(2.5);
    assertThat(kit.log("Lonely"))
        .anyMatch(line -> line.contains("WARN") && line.contains("the sonar is lost: unplugged"));
  }

  @Test
  void malformed_flood_isSaidAtPowersOfTwo() {
    link.fromDevice(new byte[60]);
    assertThat(lastError()).hasValue("the sonar sent invalid data (32 times so far), last: noise");
    assertThat(kit.log("Listener").stream().filter(line -> line.contains("unreadable"))).hasSize(6);
  }
}
