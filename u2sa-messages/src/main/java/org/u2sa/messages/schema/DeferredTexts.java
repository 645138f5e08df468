package org.u2sa.messages.schema;

import java.util.AbstractList;
import java.util.List;
import java.util.RandomAccess;
import java.util.function.Supplier;

/**
 * An immutable list of texts, created lazily on first access: messages within one process are not
 * encoded, so it is never created for them. Thread-safe.
 */
public final class DeferredTexts extends AbstractList<String> implements RandomAccess {
  private final Supplier<List<String>> maker;
  private volatile List<String> made; // null until first access; equal whichever thread creates it

  /**
   * Creates a list whose texts are computed on first access.
   *
   * @param maker returns the same texts on every call and thread, within the bounds of a message's
   *     texts
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
