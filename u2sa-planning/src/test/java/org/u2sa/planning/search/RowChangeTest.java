package org.u2sa.planning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RowChangeTest {
  private static final int BEGIN = 7; // of the row in both arrays
  private static final int LENGTH = 300;

  private final byte[] before = new byte[400];
  private final byte[] after = new byte[400];
  private final RowChange change = new RowChange();

  RowChangeTest() {
    new Random(1).nextBytes(before);
    System.arraycopy(before, 0, after, 0, before.length);
  }

  @Test
  void find_sameRowBetweenOthersThatDiffer_isNone() {
    after[BEGIN - 1]++;
    after[BEGIN + LENGTH]++;
    assertThat(change.find(before, after, BEGIN, LENGTH)).isFalse();
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "0, 299", "17, 17", "63, 64", "64, 128", "200, 236", "235, 299", "299, 299"})
  void find_cellsThatDiffer_saysTheFirstAndTheLast(int first, int last) {
    after[BEGIN + first]++;
    after[BEGIN + last] = (byte) ~before[BEGIN + last];
    after[BEGIN + (first + last) / 2] = (byte) ~before[BEGIN + (first + last) / 2];

    assertThat(change.find(before, after, BEGIN, LENGTH)).isTrue();
    assertThat(change.first()).isEqualTo(first);
    assertThat(change.last()).isEqualTo(last);
  }
}
