package org.u2sa.android.screen

import android.content.Context
import android.content.res.Configuration
import android.graphics.Color
import android.util.DisplayMetrics
import android.util.TypedValue
import org.u2sa.android.vehicle.StatusLine

/** Colours distinguishable in darkness, in sunlight and with red-green colour blindness. */
internal class Palette(context: Context) {
    private val dark =
        context.resources.configuration.uiMode and Configuration.UI_MODE_NIGHT_MASK == Configuration.UI_MODE_NIGHT_YES

    val text: Int = if (dark) Color.WHITE else Color.rgb(0x1A, 0x1A, 0x1A)
    val track: Int = if (dark) Color.rgb(0x64, 0xB5, 0xF6) else Color.rgb(0x0D, 0x47, 0xA1)
    val goal: Int = if (dark) Color.rgb(0xFF, 0xB7, 0x4D) else Color.rgb(0xB7, 0x4A, 0x00)
    val vehicle: Int = if (dark) Color.rgb(0xF4, 0x8F, 0xB1) else Color.rgb(0xAD, 0x14, 0x57)
    val emergency: Int = Color.rgb(0xC6, 0x28, 0x28)
    val onEmergency: Int = Color.WHITE

    /** Background of the status line; the text is white. */
    fun status(level: StatusLine.Level): Int = when (level) {
        StatusLine.Level.IDLE -> Color.rgb(0x45, 0x5A, 0x64)
        StatusLine.Level.GOOD -> Color.rgb(0x1B, 0x5E, 0x20)
        StatusLine.Level.MOVING -> Color.rgb(0x0D, 0x47, 0xA1)
        StatusLine.Level.WRONG -> Color.rgb(0xB7, 0x1C, 0x1C)
    }
}

/** Pixels per scaled pixel (sp), respecting the user's text size. */
internal fun DisplayMetrics.scaledDensity(): Float = TypedValue.applyDimension(TypedValue.COMPLEX_UNIT_SP, 1f, this)
