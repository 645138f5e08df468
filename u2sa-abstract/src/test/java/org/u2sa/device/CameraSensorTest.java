package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

class CameraSensorTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();
  private final ShownFrames camera = new ShownFrames();

  /** A camera that sees what a test shows it. */
  private static final class ShownFrames implements Camera {
    private volatile Optional<CameraFrame> shown = Optional.empty();
    private volatile String trouble = "";
    private volatile boolean isClosed;

    @Override
    public Optional<CameraFrame> read(long nowMicros) {
      return shown;
    }

    @Override
    public boolean isConnected() {
      return trouble.isEmpty();
    }

    @Override
    public String trouble() {
      return trouble;
    }

    @Override
    public void close() {
      isClosed = true;
    }
  }

  /** Remembers what it saw. */
  private static final class Eye extends CameraSensor {
    private final List<CameraFrame> seen = new ArrayList<>();

    Eye(ServiceContext context, Camera camera) {
      super(context, "Eye", camera);
    }

    @Override
    protected void look(CameraFrame frame) {
      seen.add(frame);
    }
  }

  private Eye start() {
    return kit.start(context -> new Eye(context, camera));
  }

  private CameraFrame show() {
    CameraFrame frame = CameraFrame.grey(kit.clock().micros(), 1, 1, new byte[] {7});
    camera.shown = Optional.of(frame);
    return frame;
  }

  @Test
  void step_eachFrame_isLookedAtOnce() {
    Eye eye = start();
    CameraFrame first = show();
    kit.advance(0.5);
    CameraFrame second = show();
    kit.advance(0.5);
    assertThat(eye.seen).containsExactly(first, second);
  }

  @Test
  void step_cameraTaken_isSaidInHealth() {
    start();
    kit.advance(1.0);
    camera.trouble = "another application took the camera";
    kit.advance(2.0);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValue("the camera is lost: another application took the camera");
  }

  @Test
  void kill_running_closesTheCamera() {
    start().kill();
    assertThat(camera.isClosed).isTrue();
  }

  @Test
  void frame_bytesThatDoNotFit_areRefusedWithTheirNumbers() {
    assertThatThrownBy(() -> CameraFrame.grey(0, 3, 2, new byte[5]))
        .hasMessage("3 x 2 pixels GREY8 are not 5 bytes");
  }
}
