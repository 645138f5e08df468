package org.u2sa.core.communication;

import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.Clock;

/**
 * Checks passwords on a thread of its own, because one check takes a fifth of a second of a core.
 *
 * <p>A flood of wrong passwords must not take the machine from control, nor lock those out who were
 * here before: a password that was right once is known again at once; after a wrong one, the same
 * name from the same address is refused unseen for a time that doubles; and after each wrong one
 * the thread rests three times as long as it worked.
 */
final class LoginDesk implements AutoCloseable {
  private static final int WAITING_AT_MOST = 64;
  private static final int FAILURES_REMEMBERED = 4_096;
  private static final long FIRST_WAIT_MICROS = 250_000;
  private static final long LONGEST_WAIT_MICROS = 30 * Clock.MICROS_PER_SECOND;
  private static final int RESTS_PER_WORK = 3;

  /** What came of it: a user, or the reason why not. */
  record Verdict(Optional<User> user, String reason) {
    static Verdict refused(String reason) {
      return new Verdict(Optional.empty(), reason);
    }
  }

  private record Application(
      User user, byte[] password, InetAddress from, Consumer<Verdict> answer) {
    String key() {
      return from.getHostAddress() + " " + user.name();
    }
  }

  private record Failures(int count, long refusedUntil) {}

  /** A password that was right: not itself, but its MAC under this run's random key. */
  private record Proven(PasswordHash hash, byte[] mac) {}

  private final Users users;
  private final Clock clock;
  private final Clock.Waiter rest;
  private final byte[] key = new byte[32];
  private final BlockingQueue<Application> waiting = new ArrayBlockingQueue<>(WAITING_AT_MOST);
  private final Map<String, Proven> proven = new ConcurrentHashMap<>();
  private final Map<String, Failures> failures = // guarded by itself
      new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Failures> eldest) {
          return size() > FAILURES_REMEMBERED;
        }
      };
  private final Thread thread = new Thread(this::work, "u2sa-login");

  LoginDesk(Users users, Clock clock) {
    this.users = users;
    this.clock = clock;
    rest = clock.newWaiter("login");
    new SecureRandom().nextBytes(key);
    thread.setDaemon(true);
    thread.start();
  }

  /** Checks a password; the answer comes at once or, when it took work, on this desk's thread. */
  void check(String name, byte[] password, InetAddress from, Consumer<Verdict> answer) {
    Optional<User> user = users.named(name);
    if (user.isEmpty()) {
      answer.accept(Verdict.refused("no such user"));
      return;
    }
    Application application = new Application(user.get(), password.clone(), from, answer);
    if (isProven(application)) {
      answer.accept(new Verdict(user, ""));
    } else if (mustWait(application)) {
      answer.accept(Verdict.refused("too soon after a wrong password"));
    } else if (!waiting.offer(application)) {
      answer.accept(Verdict.refused("too many log in at once"));
    }
  }

  private boolean isProven(Application application) {
    Proven known = proven.get(application.user.name());
    return known != null
        && known.hash.toString().equals(application.user.password().toString())
        && MessageDigest.isEqual(known.mac, mac(application.password));
  }

  private byte[] mac(byte[] password) {
    try {
      Mac mac = Mac.getInstance("HmacSHA256");
      mac.init(new SecretKeySpec(key, "HmacSHA256"));
      return mac.doFinal(password);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("this Java has no HmacSHA256", e);
    }
  }

  private boolean mustWait(Application application) {
    synchronized (failures) {
      Failures before = failures.get(application.key());
      return before != null && clock.micros() < before.refusedUntil;
    }
  }

  private void work() {
    try {
      // Java's first hash takes seconds on a small machine, longer than a client waits.
      new PasswordHash(PasswordHash.ITERATIONS, new byte[1], new byte[1]).matches(new char[1]);
      while (!Thread.currentThread().isInterrupted()) {
        Application application = waiting.take();
        long begun = clock.micros();
        if (isProven(application)) {
          application.answer.accept(new Verdict(Optional.of(application.user), ""));
        } else if (mustWait(application)) {
          application.answer.accept(Verdict.refused("too soon after a wrong password"));
        } else if (isRight(application)) {
          application.answer.accept(new Verdict(Optional.of(application.user), ""));
        } else {
          application.answer.accept(Verdict.refused("wrong password"));
          long now = clock.micros();
          rest.await(now + RESTS_PER_WORK * (now - begun));
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // the end
    }
  }

  private boolean isRight(Application application) {
    PasswordHash hash = application.user.password();
    String text = new String(application.password, StandardCharsets.UTF_8);
    if (hash.matches(text.toCharArray())) {
      proven.put(application.user.name(), new Proven(hash, mac(application.password)));
      synchronized (failures) {
        failures.remove(application.key());
      }
      return true;
    }
    synchronized (failures) {
      Failures before = failures.getOrDefault(application.key(), new Failures(0, 0));
      int count = before.count + 1;
      long wait = Math.min(FIRST_WAIT_MICROS << Math.min(count - 1, 20), LONGEST_WAIT_MICROS);
      failures.put(application.key(), new Failures(count, clock.micros() + wait));
    }
    return false;
  }

  @Override
  public void close() {
    thread.interrupt();
    rest.close();
  }
}
