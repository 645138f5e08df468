package org.u2sa.core.communication;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.access.Authenticator;
import org.u2sa.core.communication.access.LoginApplication;
import org.u2sa.core.communication.access.Users;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.time.SystemClock;

/** Who is checked, in which order, and who is told to come again. */
@Timeout(120)
class AuthenticatorTest {
  private static final String RIGHT = "right password";

  @TempDir Path folder;
  private Authenticator desk;
  private final List<String> troubles = new CopyOnWriteArrayList<>();
  private final List<String> order = new CopyOnWriteArrayList<>();
  private final List<LoginApplication.Verdict> verdicts = new CopyOnWriteArrayList<>();

  @BeforeEach
  void start() {
    PasswordHash hash = PasswordHash.of(RIGHT.toCharArray(), new SecureRandom(), 1_000);
    UserFile.write(
        folder.resolve("users.txt"),
        List.of(new User("pilot", EnumSet.of(AccessRole.OPERATOR), List.of("*"), hash)));
    desk = new Authenticator(users(), new SystemClock(), troubles::add);
  }

  private Users users() {
    return new Users(folder.resolve("users.txt"), line -> {});
  }

  @AfterEach
  void stop() {
    desk.close();
  }

  private static InetAddress address(int number) {
    try {
      return InetAddress.getByAddress(new byte[] {10, 0, (byte) (number >> 8), (byte) number});
    } catch (UnknownHostException e) {
      throw new AssertionError(e);
    }
  }

  private void check(String name, String password, int from) {
    desk.check(
        name,
        password.getBytes(UTF_8),
        address(from),
        verdict -> {
          verdicts.add(verdict);
          order.add(verdict.user().map(User::name).orElse(verdict.reason()));
        });
  }

  @Test
  void check_answerFails_isReportedAndTheNextOneIsChecked() {
    desk.check(
        "nobody",
        new byte[1],
        address(1),
        verdict -> {
          throw new IllegalStateException("odd");
        });
    check("pilot", RIGHT, 2);

    soon().until(() -> order.contains("pilot"));
    assertThat(troubles).containsExactly("\"nobody\": java.lang.IllegalStateException: odd");
  }

  @Test
  void check_rightPasswordBehindAFloodOfWrongOnes_isJudgedAndNeverRefusedForGood() {
    for (int attempt = 0; attempt < 3; attempt++) {
      for (int from = 1; from <= 120; from++) {
        check("pilot", "guess " + attempt, from);
      }
    }
    check("pilot", RIGHT, 999);

    soon().until(() -> order.contains("pilot"));
    assertThat(verdicts)
        .filteredOn(verdict -> verdict.user().isEmpty() && verdict.isFinal())
        .allMatch(verdict -> verdict.reason().equals("wrong password"));
  }

  @Test
  void check_addressWithoutWrongPasswords_comesBeforeThoseWithSome() {
    for (int from = 1; from <= 20; from++) {
      check("pilot", "guess", from);
    }
    soon().until(() -> order.size() == 20);
    for (int from = 1; from <= 20; from++) {
      check("nobody", "guess", from);
    }
    check("pilot", RIGHT, 999);

    soon().until(() -> order.contains("pilot"));
    assertThat(order.indexOf("pilot")).as("behind those being checked").isLessThan(22);
  }

  @Test
  void check_nameThatNobodyHas_isWorkedForAndAnsweredLikeAWrongPassword() {
    check("nobody", "guess", 1);

    assertThat(order).as("answered before any work was done").isEmpty();
    soon().until(() -> !order.isEmpty());
    assertThat(verdicts.get(0).isFinal()).isTrue();
    check("nobody", "guess", 1);
    assertThat(verdicts.get(1))
        .isEqualTo(LoginApplication.Verdict.later("too soon after a wrong password"));
  }

  @Test
  void check_processHasHashedBefore_takesThePasswordsOwnTimeOnly() {
    check("pilot", RIGHT, 1);
    soon().until(() -> order.contains("pilot"));
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long began = threads.getCurrentThreadCpuTime();
    PasswordHash.unguessable(new SecureRandom()).matches(new char[1]);
    long advised = threads.getCurrentThreadCpuTime() - began;
    Set<Long> others = logins(threads);

    try (Authenticator another = new Authenticator(users(), new SystemClock(), troubles::add)) {
      another.check("pilot", RIGHT.getBytes(UTF_8), address(1), verdicts::add);
      soon().until(() -> verdicts.size() > 1);

      assertThat(logins(threads))
          .filteredOn(id -> !others.contains(id))
          .allMatch(id -> threads.getThreadCpuTime(id) < advised / 4);
    }
  }

  /** The authenticators' threads. */
  private static Set<Long> logins(ThreadMXBean threads) {
    return Stream.of(threads.getThreadInfo(threads.getAllThreadIds()))
        .filter(thread -> thread != null && thread.getThreadName().equals("u2sa-login"))
        .map(ThreadInfo::getThreadId)
        .collect(Collectors.toSet());
  }

  @Test
  void check_moreThanCanWaitFromOneAddress_areToldToComeAgain() {
    for (int i = 0; i < 50; i++) {
      check("user" + i, "guess", 1);
    }
    assertThat(verdicts).contains(LoginApplication.Verdict.later("too many log-ins at once"));
    assertThat(verdicts).extracting(LoginApplication.Verdict::user).containsOnly(Optional.empty());
  }
}
