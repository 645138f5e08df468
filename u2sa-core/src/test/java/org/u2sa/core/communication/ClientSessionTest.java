package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import io.netty.channel.DefaultEventLoop;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.EnumSet;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.access.Authenticator;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.time.SystemClock;

class ClientSessionTest {
  private static DefaultEventLoop ended() throws InterruptedException {
    DefaultEventLoop loop = new DefaultEventLoop();
    loop.shutdownGracefully(0, 0, TimeUnit.SECONDS).sync();
    return loop;
  }

  @Test
  void execute_threadOfTheConnectionHasEnded_dropsTheAction() throws InterruptedException {
    DefaultEventLoop loop = ended();
    AtomicBoolean ran = new AtomicBoolean();

    assertThatCode(() -> Client.execute(loop, () -> ran.set(true))).doesNotThrowAnyException();

    assertThat(ran).isFalse();
  }

  @Test
  void execute_verdictAfterTheBrokerHasEnded_leavesTheLoginThreadWorking(@TempDir Path folder)
      throws Exception {
    DefaultEventLoop loop = ended();
    AtomicReference<Throwable> uncaught = new AtomicReference<>();
    AtomicBoolean answered = new AtomicBoolean();
    InetAddress from = InetAddress.getLoopbackAddress();
    InetAddress other = InetAddress.getByAddress(new byte[] {10, 0, 0, 1});
    Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
    Thread.setDefaultUncaughtExceptionHandler((thread, thrown) -> uncaught.set(thrown));
    PasswordHash hash = PasswordHash.of("right".toCharArray(), new SecureRandom(), 1_000);
    Path file = folder.resolve("users.txt");
    UserFile.write(
        file, List.of(new User("pilot", EnumSet.of(AccessRole.OPERATOR), List.of("*"), hash)));
    Users users = new Users(file, line -> {});
    try (Authenticator authenticator = new Authenticator(users, new SystemClock(), what -> {})) {
      authenticator.check("pilot", new byte[1], from, verdict -> Client.execute(loop, () -> {}));
      byte[] right = "right".getBytes(StandardCharsets.UTF_8);
      authenticator.check("pilot", right, other, verdict -> answered.set(true));
      BrokerTraffic.soon().until(() -> answered.get() || uncaught.get() != null);
    } finally {
      Thread.setDefaultUncaughtExceptionHandler(before);
    }

    assertThat(uncaught.get()).isNull();
    assertThat(answered).isTrue();
  }
}
