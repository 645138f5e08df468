package org.u2sa.core.security;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Base64;
import java.util.EnumSet;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PasswordHashTest {
  private static final int FEW = 10; // iterations: a test need not resist anybody
  private static final SecureRandom RANDOM = new SecureRandom();

  /** Worked out by Python: hashlib.pbkdf2_hmac("sha512", b"secret", b"saltsaltsalt", 1000). */
  private static final String REFERENCE =
      "6de3f35a8ffbf7a4866769412a965c5361508505e78e21000e7bd4f322f36b1b"
          + "b5070952474efaad359e191aef801cfbe7b0f134f9ad019a5596ce714a2f5d6b";

  private static String line(int iterations, int saltBytes, int hashBytes) {
    Base64.Encoder base64 = Base64.getEncoder();
    return "pbkdf2-sha512$"
        + iterations
        + "$"
        + base64.encodeToString(new byte[saltBytes])
        + "$"
        + base64.encodeToString(new byte[hashBytes]);
  }

  @Test
  void matches_hashOfAnotherLibrary_isTheSameFunction() {
    byte[] hash = HexFormat.of().parseHex(REFERENCE);
    PasswordHash kept = new PasswordHash(1_000, "saltsaltsalt".getBytes(UTF_8), hash);

    assertThat(kept.matches("secret".toCharArray())).isTrue();
    assertThat(kept.matches("secreT".toCharArray())).isFalse();
    assertThat(kept.matches(new char[0])).isFalse();
  }

  @Test
  void forMosquitto_anyPassword_isItsFormatWithTwelveBytesOfSalt() {
    PasswordHash kept = PasswordHash.of("secret".toCharArray(), RANDOM, FEW);

    String[] parts = kept.forMosquitto().split("\\$");
    assertThat(parts).startsWith("", "7", "10").hasSize(5);
    assertThat(Base64.getDecoder().decode(parts[3])).hasSize(12).isEqualTo(kept.salt());
    assertThat(Base64.getDecoder().decode(parts[4])).hasSize(64).isEqualTo(kept.hash());
    assertThat(PasswordHash.parse(kept.toString())).isEqualTo(kept);
  }

  @Test
  void of_samePasswordTwice_saltsDiffer() {
    PasswordHash one = PasswordHash.of("secret".toCharArray(), RANDOM, FEW);
    PasswordHash other = PasswordHash.of("secret".toCharArray(), RANDOM, FEW);
    assertThat(one.salt()).isNotEqualTo(other.salt());
    assertThat(one.hash()).isNotEqualTo(other.hash());
  }

  @Test
  void of_unsaidIterations_areTheAdvised() {
    PasswordHash kept = PasswordHash.of("secret".toCharArray(), RANDOM);
    assertThat(kept.iterations()).isEqualTo(PasswordHash.ITERATIONS);
    assertThat(kept.matches("secret".toCharArray())).isTrue();
  }

  @Test
  void unguessable_two_areRandomAndAsSlowAsAny() {
    PasswordHash one = PasswordHash.unguessable(RANDOM);
    PasswordHash other = PasswordHash.unguessable(RANDOM);
    assertThat(one.iterations()).isEqualTo(PasswordHash.ITERATIONS);
    assertThat(one.salt()).hasSize(12).isNotEqualTo(other.salt());
    assertThat(one.hash()).hasSize(64).isNotEqualTo(other.hash());
    assertThat(one.matches(new char[0])).isFalse();
  }

  @Test
  void saltAndHash_changedOutside_stayInside() {
    byte[] salt = new byte[12];
    byte[] hash = new byte[64];
    PasswordHash kept = new PasswordHash(FEW, salt, hash);
    salt[0] = 1;
    hash[0] = 1;
    kept.salt()[1] = 1;
    kept.hash()[1] = 1;

    assertThat(kept).isEqualTo(new PasswordHash(FEW, new byte[12], new byte[64]));
  }

  @Test
  void equals_anotherInOnePart_isNotTheSame() {
    PasswordHash kept = new PasswordHash(FEW, new byte[12], new byte[64]);
    byte[] otherHash = new byte[64];
    Arrays.fill(otherHash, (byte) 1);
    byte[] otherSalt = new byte[12];
    Arrays.fill(otherSalt, (byte) 1);

    assertThat(kept)
        .isNotEqualTo(new PasswordHash(FEW + 1, new byte[12], new byte[64]))
        .isNotEqualTo(new PasswordHash(FEW, otherSalt, new byte[64]))
        .isNotEqualTo(new PasswordHash(FEW, new byte[12], otherHash))
        .isNotEqualTo(kept.toString());
    assertThat(new PasswordHash(FEW, new byte[12], otherHash)).doesNotHaveSameHashCodeAs(kept);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 64, true",
    "10000000, 64, true",
    "0, 64, false",
    "10000001, 64, false",
    "1, 63, false",
    "1, 65, false"
  })
  void parse_iterationsAndLength_boundsAreTaken(int iterations, int hashBytes, boolean taken) {
    String line = line(iterations, 12, hashBytes);
    if (taken) {
      assertThat(PasswordHash.parse(line).iterations()).isEqualTo(iterations);
    } else {
      assertThatThrownBy(() -> PasswordHash.parse(line))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("expected 1…10000000 iterations and a hash of 64 bytes");
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "md5$1$AA==$AA==", "pbkdf2-sha512$1$AA==", "pbkdf2-sha512$1$AA==$AA==$"})
  void parse_anotherForm_saysWhichIsExpected(String text) {
    assertThatThrownBy(() -> PasswordHash.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("expected pbkdf2-sha512$iterations$salt$hash");
  }

  @Test
  void user_roles_areSortedAndOnlyTheOperatorClearsAStop() {
    PasswordHash any = new PasswordHash(FEW, new byte[12], new byte[64]);
    List<String> all = List.of(User.EVERY_SYSTEM);
    User several = new User("a", User.rolesOf(" observer, control,,"), all, any);
    assertThat(several.rolesText()).isEqualTo("control,observer");
    for (AccessRole role : AccessRole.values()) {
      assertThat(new User("a", EnumSet.of(role), all, any).mayClearEmergencyStop())
          .isEqualTo(role == AccessRole.OPERATOR);
    }
    assertThatThrownBy(() -> User.rolesOf("captain"))
        .hasMessage(
            "role \"captain\": expected one of service, control, launcher, monitor, safety,"
                + " operator, observer");
    assertThatThrownBy(() -> new User("a", EnumSet.of(AccessRole.SAFETY), List.of(), any))
        .hasMessageContaining("at least one role and one system");
    assertThatThrownBy(() -> new User("a b", EnumSet.of(AccessRole.SAFETY), all, any))
        .hasMessageContaining("user \"a b\": expected 1 to 64 letters");
  }
}
