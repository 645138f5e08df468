package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.access.LoginApplication;
import org.u2sa.core.communication.access.LoginFailures;
import org.u2sa.core.communication.access.LoginQueue;
import org.u2sa.interfaces.time.Clock;

/** Whose password is checked next, and who must wait how long after a wrong one. */
class LoginOrderTest {
  private long nowMicros = 1_000_000_000L;

  private final LoginFailures failures =
      new LoginFailures(
          new Clock() {
            @Override
            public long micros() {
              return nowMicros;
            }

            @Override
            public Waiter newWaiter(String name) {
              throw new IllegalStateException(name + " does not wait");
            }
          });
  private final LoginQueue queue = new LoginQueue(failures);

  private static LoginApplication by(String name, String address) {
    try {
      return new LoginApplication(name, new byte[0], InetAddress.getByName(address), verdict -> {});
    } catch (UnknownHostException e) {
      throw new AssertionError(e);
    }
  }

  /** How long the name must wait from now on [µs], to a quarter of a second. */
  private long waitAfterOneMoreWrong(LoginApplication application) {
    failures.add(application);
    long from = nowMicros;
    while (failures.mustWait(application)) {
      nowMicros += 250_000;
    }
    return nowMicros - from;
  }

  @Test
  void mustWait_afterEachWrongPassword_twiceAsLongUpToHalfAMinute() {
    LoginApplication pilot = by("pilot", "10.0.0.1");
    assertThat(failures.mustWait(pilot)).isFalse();

    for (long expected = 250_000; expected <= 16_000_000; expected *= 2) {
      assertThat(waitAfterOneMoreWrong(pilot)).isEqualTo(expected);
    }
    for (int i = 0; i < 80; i++) { // past what a long holds of doublings
      assertThat(waitAfterOneMoreWrong(pilot)).isEqualTo(30_000_000);
    }
    assertThat(failures.from(pilot)).isEqualTo(87);
  }

  @Test
  void mustWait_othersThanWhoWasWrong_doNot() {
    failures.add(by("pilot", "10.0.0.1"));

    assertThat(failures.mustWait(by("pilot", "10.0.0.1"))).isTrue();
    assertThat(failures.mustWait(by("pilot", "10.0.0.2"))).isFalse();
    assertThat(failures.mustWait(by("gunner", "10.0.0.1"))).isFalse();
    assertThat(failures.from(by("gunner", "10.0.0.1"))).isEqualTo(1);
    assertThat(failures.from(by("pilot", "10.0.0.2"))).isZero();
  }

  @Test
  void forget_afterTheRightPassword_theNameIsFreeAndTheAddressIsNot() {
    LoginApplication pilot = by("pilot", "10.0.0.1");
    failures.add(pilot);
    failures.forget(pilot);

    assertThat(failures.mustWait(pilot)).isFalse();
    assertThat(failures.from(pilot)).isEqualTo(1);
  }

  @Test
  void from_tenMinutesLater_isForgotten() {
    LoginApplication pilot = by("pilot", "10.0.0.1");
    failures.add(pilot);
    nowMicros += 599_999_999;
    assertThat(failures.from(pilot)).isEqualTo(1);
    nowMicros += 1;
    assertThat(failures.from(pilot)).isZero();
    assertThat(waitAfterOneMoreWrong(pilot)).as("the first again").isEqualTo(250_000);
  }

  /** An attacker with ever new names or addresses fills no memory and buys nobody's oblivion. */
  @Test
  void add_moreThanAreRemembered_forgetsTheOldestFirst() {
    failures.add(by("early", "10.9.9.9"));
    for (int i = 0; i < 4_095; i++) {
      failures.add(by("guess", "10.1." + i / 256 + "." + i % 256));
    }
    assertThat(failures.from(by("early", "10.9.9.9"))).isEqualTo(1);
    failures.add(by("guess", "10.2.0.0"));
    failures.add(by("guess", "10.2.0.1"));

    assertThat(failures.from(by("early", "10.9.9.9"))).as("looked at just now").isEqualTo(1);
    assertThat(failures.from(by("guess", "10.1.0.0"))).isZero();
    assertThat(failures.from(by("guess", "10.2.0.1"))).isEqualTo(1);
  }

  /** Whoever has one address of IPv6 has all of its network. */
  @Test
  void from_anotherAddressOfOneNetwork_isTheSame() {
    failures.add(by("pilot", "2001:db8:1:2::1"));
    assertThat(failures.mustWait(by("pilot", "2001:db8:1:2:ffff::9"))).isTrue();
    assertThat(failures.mustWait(by("pilot", "2001:db8:1:3::1"))).isFalse();
  }

  @Test
  void poll_withoutWrongPasswords_inTheOrderInWhichTheyCame() {
    LoginApplication first = by("a", "10.0.0.1");
    LoginApplication second = by("b", "10.0.0.2");
    assertThat(queue.add(first)).isEmpty();
    assertThat(queue.add(second)).isEmpty();

    assertThat(queue.poll(true)).containsSame(first);
    assertThat(queue.poll(false)).containsSame(second);
    assertThat(queue.poll(false)).isEmpty();
  }

  @Test
  void poll_addressesWithWrongPasswords_comeLastAndNotAmongTheBlameless() {
    LoginApplication blamed = by("a", "10.0.0.1");
    LoginApplication blameless = by("b", "10.0.0.2");
    failures.add(blamed);
    queue.add(blamed);
    queue.add(blameless);

    assertThat(queue.poll(true)).containsSame(blameless);
    assertThat(queue.poll(true)).isEmpty();
    assertThat(queue.poll(false)).containsSame(blamed);
  }

  @Test
  void add_ninthOfOneAddress_hasNoPlace() {
    for (int i = 0; i < 8; i++) {
      assertThat(queue.add(by("a" + i, "10.0.0.1"))).isEmpty();
    }
    LoginApplication ninth = by("a8", "10.0.0.1");
    assertThat(queue.add(ninth)).containsSame(ninth);
    assertThat(queue.add(by("a8", "10.0.0.2"))).isEmpty();
  }

  @Test
  void add_toAFullQueue_costsThePlaceOfWhoHasMostWrongPasswordsThenMostPlaces() {
    LoginApplication blamed = by("guess", "10.0.0.1");
    failures.add(blamed);
    queue.add(blamed);
    for (int i = 0; i < 253; i++) {
      assertThat(queue.add(by("a", "10.0.1." + i))).isEmpty();
    }
    queue.add(by("b", "10.0.2.2"));
    queue.add(by("c", "10.0.2.2"));
    assertThat(queue.add(by("late", "10.0.3.1"))).containsSame(blamed);

    Optional<LoginApplication> next = queue.add(by("later", "10.0.3.2"));
    assertThat(next.orElseThrow().from()).isEqualTo("10.0.2.2");
  }
}
