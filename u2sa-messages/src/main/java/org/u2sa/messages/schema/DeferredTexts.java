package org.u2sa.messages.schema;

import java.util.AbstractList;
import java.util.List;
import java.util.RandomAccess;
import java.util.function.Supplier;

/**
 * An immutable list of texts that is made when somebody first asks for it: between services of one
 * process nobody does, as messages are not written there. For any thread.
 */
public final class DeferredTexts extends AbstractList<String> implements RandomAccess {
  private final Supplier<List<String>> maker;
  private volatile List<String> made; // null until somebody asks; the same whoever makes it

  /**
   * Texts yet to be made.
   *
   * @param maker gives the same each time, on any thread; what it gives must be within the bounds
   *     of a message's texts
   */
  public DeferredTexts(Supplier<List<String>> maker) {
    this.maker = maker;
  }

  private List<String> made() {
    List<String> texts = made;
    if (texts == null) {
      texts = ListKinds.TEXTS.checked(maker.get());
      made = texts;
    }
    return texts;
  }

  @Override
  public String get(int index) {
    return made().get(index);
  }

  @Override
  public int size() {
    return made().size();
  }
}
