package org.u2sa.core.communication.access;

import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.time.Clock;

/**
 * Checks passwords on its own thread, because one check takes 0.2 s of CPU time.
 *
 * <p>A flood of wrong passwords must neither starve control of CPU time nor lock out legitimate
 * users. Correct passwords are cached. After a wrong password, further attempts with the same name
 * and address are refused unchecked, with exponential back-off. Addresses without wrong passwords
 * go first; after each check for any other address the thread sleeps for three times as long as the
 * check took. A refusal is final only after a check, which takes as long for unknown names.
 */
public final class Authenticator implements AutoCloseable {
  private static final int RESTS_PER_WORK = 3;

  /** MAC of a correct password under this run's random key. */
  private record Proven(PasswordHash hash, byte[] mac) {}

  /** The first hash of a process takes seconds on a small machine, longer than clients wait. */
  private static final class WarmUp {
    static {
      PasswordHash.unguessable(new SecureRandom()).matches(new char[1]);
    }

    /** Returns when the class is initialized: the process has hashed once. */
    static void once() {}
  }

  private final Users users;
  private final Clock clock;
  private final Consumer<String> trouble;
  private final Clock.Waiter waiter;
  private final byte[] key = new byte[32];
  private final PasswordHash nobodys; // in place of an unknown user's hash
  private final LoginFailures failures;
  private final LoginQueue queue;
  private final Map<String, Proven> proven = new ConcurrentHashMap<>();
  private final Thread thread = new Thread(this::work, "u2sa-login");
  private long restUntil = Long.MIN_VALUE; // used by the thread only

  /**
   * @param trouble called when a password could not be checked
   */
  public Authenticator(Users users, Clock clock, Consumer<String> trouble) {
    this.users = users;
    this.clock = clock;
    this.trouble = trouble;
    waiter = clock.newWaiter("login");
    SecureRandom random = new SecureRandom();
    random.nextBytes(key);
    nobodys = PasswordHash.unguessable(random);
    failures = new LoginFailures(clock);
    queue = new LoginQueue(failures);
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * Checks a password; the answer comes immediately or, if it takes work, on the authenticator's
   * thread.
   */
  public void check(
      String name, byte[] password, InetAddress from, Consumer<LoginApplication.Verdict> answer) {
    LoginApplication application = new LoginApplication(name, password.clone(), from, answer);
    Optional<User> user = users.named(name);
    if (user.isPresent() && isProven(user.get(), password)) {
      answer.accept(LoginApplication.Verdict.of(user.get()));
      return;
    }
    if (failures.mustWait(application)) {
      answer.accept(LoginApplication.Verdict.later("too soon after a wrong password"));
      return;
    }
    queue
        .add(application)
        .ifPresent(
            out -> out.answer().accept(LoginApplication.Verdict.later("too many log-ins at once")));
    waiter.signal();
  }

  private boolean isProven(User user, byte[] password) {
    Proven known = proven.get(user.name());
    return known != null
        && known.hash.toString().equals(user.password().toString())
        && MessageDigest.isEqual(known.mac, mac(password));
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

  private void work() {
    try {
      WarmUp.once();
      while (!Thread.currentThread().isInterrupted()) {
        boolean rests = clock.micros() < restUntil;
        Optional<LoginApplication> next = queue.poll(rests);
        if (next.isPresent()) {
          tryToJudge(next.get());
        } else {
          waiter.await(rests ? restUntil : Clock.NEVER);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // shut down
    }
  }

  /** Decides on a login; a failure must not prevent other logins. */
  private void tryToJudge(LoginApplication application) {
    try {
      judge(application);
    } catch (RuntimeException | OutOfMemoryError e) {
      trouble.accept(Refusals.shown(application.name()) + ": " + e);
    }
  }

  private void judge(LoginApplication application) {
    Optional<User> user = users.named(application.name());
    if (user.isPresent() && isProven(user.get(), application.password())) {
      application.answer().accept(LoginApplication.Verdict.of(user.get()));
    } else if (failures.mustWait(application)) {
      application
          .answer()
          .accept(LoginApplication.Verdict.later("too soon after a wrong password"));
    } else {
      long begun = clock.micros();
      application.answer().accept(checked(user, application));
      long now = clock.micros();
      restUntil = now + RESTS_PER_WORK * (now - begun);
    }
  }

  private LoginApplication.Verdict checked(Optional<User> user, LoginApplication application) {
    PasswordHash hash = user.map(User::password).orElse(nobodys);
    String text = new String(application.password(), StandardCharsets.UTF_8);
    boolean right = hash.matches(text.toCharArray());
    if (right && user.isPresent()) {
      proven.put(application.name(), new Proven(hash, mac(application.password())));
      failures.forget(application);
      return LoginApplication.Verdict.of(user.get());
    }
    failures.add(application);
    return LoginApplication.Verdict.wrong(user.isPresent() ? "wrong password" : "no such user");
  }

  @Override
  public void close() {
    thread.interrupt();
    waiter.close();
  }
}
