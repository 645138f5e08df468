package org.u2sa.interfaces.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.u2sa.interfaces.BadInputException;

class XmlTextProperties {
  private static final String TEXT =
      "<?xml version=\"1.0\" encoding=\"%s\"?><r><!-- a='1' --><e b='>' a=%sold%s/>tail</r>"
          .replace("tail", "<f/>");

  @Provide
  Arbitrary<String> xmlText() {
    return Arbitraries.strings()
        .withChars('\t', '\n', '\r', '&', '<', '>', '"', '\'', ';', '#', ' ', '\u0085', '\u2028')
        .withCharRange(' ', '\uD7FF')
        .withCharRange('\uE000', '\uFFFD')
        .ofMaxLength(40)
        .map(text -> text + new String(Character.toChars(0x1F680)));
  }

  @Property(tries = 1000)
  void withAttribute_anyXmlText_isReadBackAndNothingElseChanges(
      @ForAll("xmlText") String value, @ForAll boolean latin, @ForAll boolean apostrophe) {
    Charset charset = latin ? StandardCharsets.ISO_8859_1 : StandardCharsets.UTF_8;
    String quote = apostrophe ? "'" : "\"";
    byte[] bytes = String.format(TEXT, charset.name(), quote, quote).getBytes(charset);
    XmlText text = XmlText.of(bytes, "test");

    byte[] changed = text.withAttribute(text.root("r").child("e").get(), "a", value).bytes();

    XmlText again = XmlText.of(changed, "test");
    XmlElement element = again.root("r").child("e").get();
    assertThat(element.attribute("a")).isEqualTo(value);
    assertThat(again.withAttribute(element, "a", "old").bytes()).isEqualTo(bytes);
  }

  @Property(tries = 300)
  void withLastChild_anyXmlText_isReadBack(@ForAll("xmlText") String value) {
    XmlText text = XmlText.of("<r>\n  <e/>\n</r>".getBytes(StandardCharsets.UTF_8), "test");

    XmlText changed = text.withLastChild(text.root("r"), "f", Map.of("a", value));

    assertThat(changed.root("r").child("f").get().attribute("a")).isEqualTo(value);
  }

  @Property(tries = 100)
  void withAttribute_characterThatXmlCannotHold_isRefused(@ForAll("forbidden") char c) {
    XmlText text = XmlText.of("<r a=''/>".getBytes(StandardCharsets.UTF_8), "test");
    XmlElement root = text.root("r");

    assertThatThrownBy(() -> text.withAttribute(root, "a", "ab" + c))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(String.format("character U+%04X at position 3 is not allowed in XML", (int) c));
  }

  @Property(tries = 1000)
  void root_brokenBytes_areReadOrRefusedAsBadInput(
      @ForAll @IntRange(max = 80) int at, @ForAll byte broken, @ForAll boolean cut) {
    byte[] bytes =
        "<?xml version='1.0'?><r>&#65;<![CDATA[]]>&amp;<e b='>' a='&lt;'/><!-- --><?p q?></r>"
            .getBytes(StandardCharsets.UTF_8);
    bytes[at] = broken;
    byte[] given = cut ? Arrays.copyOf(bytes, at) : bytes;
    try {
      assertThat(XmlText.of(given, "test").root("r").name()).isEqualTo("r");
    } catch (BadInputException e) {
      assertThat(e.getMessage()).startsWith("test, line ").doesNotContain("\n");
    }
  }

  @Provide
  Arbitrary<Character> forbidden() {
    return Arbitraries.oneOf(
        Arbitraries.chars().range('\u0000', '\u0008'),
        Arbitraries.chars().range('\u000E', '\u001F'),
        Arbitraries.chars().range('\uD800', '\uDFFF'),
        Arbitraries.chars().range('\uFFFE', '\uFFFF'));
  }
}
