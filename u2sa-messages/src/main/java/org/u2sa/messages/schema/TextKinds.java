package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;

/**
 * Kinds of texts with their own bounds. Overlong names and identifiers are rejected, because
 * truncated ones could be ambiguous. Notes are human-readable texts that often quote other
 * messages: they are truncated instead of rejected, so that setting one never fails.
 */
final class TextKinds {
  static final ValueKind<String> NAME = new Bounded(Limits.NAME_CHARS);
  static final ValueKind<String> ID = new Bounded(Limits.ID_CHARS);
  static final ValueKind<List<String>> IDS = ListKinds.texts(ID);
  static final ValueKind<String> NOTE = new Note();
  static final ValueKind<List<String>> NOTES = new Notes(ListKinds.TEXTS);

  private static final String CUT = "…";

  private TextKinds() {}

  /** At most {@link Limits#NOTE_CHARS} characters of valid Unicode. */
  private static String shortened(String text) {
    if (text.length() <= Limits.NOTE_CHARS && isUnicode(text)) {
      return text;
    }
    StringBuilder kept = new StringBuilder(Math.min(text.length(), Limits.NOTE_CHARS));
    int end = text.length() <= Limits.NOTE_CHARS ? text.length() : Limits.NOTE_CHARS - 1;
    for (int i = 0; i < end; i++) {
      boolean isPair = i + 1 < end && Character.isSurrogatePair(text.charAt(i), text.charAt(i + 1));
      if (isPair) {
        kept.append(text, i, i + 2);
        i++;
      } else {
        kept.append(Character.isSurrogate(text.charAt(i)) ? '\ufffd' : text.charAt(i));
      }
    }
    return kept.append(end < text.length() ? CUT : "").toString();
  }

  private static boolean isUnicode(String text) {
    for (int i = 0; i < text.length(); i++) {
      if (Character.isSurrogate(text.charAt(i))) {
        return false; // most texts have no surrogates; pairing is checked later
      }
    }
    return true;
  }

  /** All but the bounds. */
  private interface Text extends ValueKind<String> {
    @Override
    default Kind kind() {
      return Kind.STRING;
    }

    @Override
    default String parsed(List<String> texts) {
      return ValueKind.only(texts);
    }

    @Override
    default void write(CborOutput out, String text) {
      out.text(text);
    }

    @Override
    default String read(CborReader in) throws MalformedMessageException {
      return in.text();
    }
  }

  private record Bounded(int longest) implements Text {
    @Override
    public String checked(Object value) {
      String text = ScalarKinds.TEXT.checked(value);
      if (text.length() > longest) {
        throw Limits.expected("at most " + longest + " characters, not " + text.length());
      }
      return text;
    }
  }

  private record Note() implements Text {
    @Override
    public int longest() {
      return Limits.NOTE_CHARS;
    }

    @Override
    public boolean shortens() {
      return true;
    }

    @Override
    public String checked(Object value) {
      if (value instanceof String text) {
        return shortened(text);
      }
      throw Limits.expected("text");
    }
  }

  private record Notes(ValueKind<List<String>> base) implements ListKinds.Derived<List<String>> {
    @Override
    public int longest() {
      return NOTE.longest();
    }

    @Override
    public boolean shortens() {
      return NOTE.shortens();
    }

    @Override
    public List<String> checked(Object value) {
      if (!(value instanceof Collection<?> notes)) {
        throw Limits.expected("a list of texts");
      }
      boolean isCut = notes.size() > Limits.NOTES;
      List<String> kept = new ArrayList<>();
      for (Object note : notes) {
        if (isCut && kept.size() == Limits.NOTES - 1) {
          kept.add("and " + (notes.size() - kept.size()) + " more");
          break;
        }
        kept.add(NOTE.checked(note));
      }
      return List.copyOf(kept);
    }
  }
}
