package org.u2sa.vision.survey;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;

/** Provides the messages of this package. */
public final class SurveyMessages implements MessageTypeProvider {
  @Override
  public List<MessageType<?>> messageTypes() {
    return List.of(SurveyTarget.TYPE);
  }
}
