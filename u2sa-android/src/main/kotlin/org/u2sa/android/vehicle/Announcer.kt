package org.u2sa.android.vehicle

import android.content.Context
import android.speech.tts.TextToSpeech
import org.u2sa.android.text.Text

/** Announces faults by speech, because people near the vehicle watch it rather than the screen. */
internal class Announcer(private val context: Context) : AutoCloseable {
    private var ready = false
    private val speech = TextToSpeech(context) { status -> ready = status == TextToSpeech.SUCCESS }

    /** Queues the texts in order; no effect without text-to-speech. */
    fun say(warnings: List<Warnings.Warning>) {
        if (ready) {
            warnings.forEach { speech.speak(words(it), TextToSpeech.QUEUE_ADD, null, it.kind.name) }
        }
    }

    private fun words(warning: Warnings.Warning): String = when (warning.kind) {
        Warnings.Kind.EMERGENCY -> Text.PHASE_EMERGENCY.of(context, warning.words)
        Warnings.Kind.FAILSAFE -> Text.FAILSAFE.of(context, warning.words, "")
        Warnings.Kind.HAZARD -> hazardText(requireNotNull(warning.hazard)).of(context)
    }

    override fun close() = speech.shutdown()
}

/** Localised text of a hazard. */
internal fun hazardText(hazard: PhoneFailsafe.Hazard): Text = when (hazard) {
    PhoneFailsafe.Hazard.BOARD_LOST -> Text.HAZARD_BOARD_LOST
    PhoneFailsafe.Hazard.POSITION_LOST -> Text.HAZARD_POSITION_LOST
    PhoneFailsafe.Hazard.BATTERY_LOW -> Text.HAZARD_BATTERY_LOW
    PhoneFailsafe.Hazard.TOO_HOT -> Text.HAZARD_TOO_HOT
}
