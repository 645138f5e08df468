package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

class TopicLevelProperties {
  @Provide
  Arbitrary<String> names() {
    return Arbitraries.strings()
        .withChars(" .*>+#/%$=\"\\0123ABCDEFabcdef")
        .withCharRange('\u0000', '\u00ff')
        .withCharRange('\u0100', '\uffff')
        .ofMinLength(1)
        .ofMaxLength(40);
  }

  @Property
  void of_anyName_isReadBackAndHasNothingThatABrokerClaims(@ForAll("names") String name) {
    String level = TopicLevel.of(name);

    assertThat(TopicLevel.name(level)).isEqualTo(name);
    assertThat(level.chars())
        .noneMatch(c -> " .*>+#/".indexOf(c) >= 0 || Character.isISOControl(c));
  }

  @Property
  void name_whatItReads_isWrittenAgainAsTheSameName(@ForAll("names") String level) {
    String name;
    try {
      name = TopicLevel.name(level);
    } catch (IllegalArgumentException refused) {
      assertThat(refused).hasMessageContaining("expected");
      return;
    }
    assertThat(TopicLevel.name(TopicLevel.of(name))).isEqualTo(name);
  }
}
