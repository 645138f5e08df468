package org.u2sa.android.screen

import org.u2sa.android.text.Text
import android.content.Context
import android.content.res.ColorStateList
import android.content.res.Configuration
import android.graphics.Color
import android.graphics.Typeface
import android.view.Gravity
import android.view.View
import android.view.ViewGroup.LayoutParams.MATCH_PARENT
import android.view.ViewGroup.LayoutParams.WRAP_CONTENT
import android.widget.Button
import android.widget.LinearLayout
import android.widget.ScrollView
import android.widget.TextView
import org.u2sa.android.vehicle.StatusLine
import org.u2sa.android.vehicle.VehicleHost
import org.u2sa.android.vehicle.VehicleSnapshot

private const val PAD_DP = 12
private const val TRACK_DP = 260
private const val EMERGENCY_DP = 96
private const val EMERGENCY_SP = 26f
private const val STATUS_SP = 18f
private const val PALE = 0.35f

/** Actions of [Panel]'s buttons. */
internal interface Orders {
    fun start()

    fun stop()

    fun arm(wanted: Boolean)

    fun emergencyStop()

    fun clearEmergencyStop()
}

/** Views of the main screen: vehicle status and buttons. The emergency stop is always visible. */
internal class Panel(private val context: Context, private val orders: Orders) {
    private val palette = Palette(context)
    private val wording = Wording(context)
    private val dp = context.resources.displayMetrics.density

    val status = text(STATUS_SP).apply {
        setTextColor(Color.WHITE)
        setTypeface(typeface, Typeface.BOLD)
        accessibilityLiveRegion = View.ACCESSIBILITY_LIVE_REGION_ASSERTIVE // read aloud on every change
    }
    val warnings = text().apply { accessibilityLiveRegion = View.ACCESSIBILITY_LIVE_REGION_POLITE }
    val track = TrackView(context)
    val facts = text()
    val services = text()
    val chosen = text()
    val start = button(Text.START, Text.START_DESCRIPTION) { orders.start() }
    val arm = button(Text.ARM, Text.ARM_DESCRIPTION) { orders.arm(true) }
    val disarm = button(Text.DISARM, Text.DISARM_DESCRIPTION) { orders.arm(false) }
    val stop = button(Text.STOP, Text.STOP_DESCRIPTION) { orders.stop() }
    val clear = button(Text.CLEAR_EMERGENCY_STOP, Text.CLEAR_EMERGENCY_STOP) { orders.clearEmergencyStop() }
    val emergency = button(Text.EMERGENCY_STOP, Text.EMERGENCY_STOP_DESCRIPTION) { orders.emergencyStop() }.apply {
        backgroundTintList = ColorStateList.valueOf(palette.emergency)
        setTextColor(palette.onEmergency)
        textSize = EMERGENCY_SP
        setTypeface(typeface, Typeface.BOLD)
        minHeight = pixels(EMERGENCY_DP)
    }

    /** Root view; side by side in landscape. */
    val root: View = if (context.resources.configuration.orientation == Configuration.ORIENTATION_LANDSCAPE) {
        row(
            column(status, track to 1f),
            column(scrolling(warnings, facts, services, chosen) to 1f, buttons(), clear, emergency),
        )
    } else {
        column(
            status,
            scrolling(warnings, track.apply { minimumHeight = pixels(TRACK_DP) }, facts, services, chosen) to 1f,
            buttons(),
            clear,
            emergency,
        )
    }.apply { fitsSystemWindows = true }

    /** Updates the views; disables buttons that do not apply. */
    fun show(state: VehicleHost.State, snapshot: VehicleSnapshot, boardTrouble: String, chosenText: String) {
        val line = StatusLine.of(context, state, snapshot)
        status.show(line.words)
        status.setBackgroundColor(palette.status(line.level))
        warnings.show(wording.warnings(snapshot, boardTrouble))
        track.show(snapshot)
        facts.show(listOf(wording.track(snapshot), wording.batteries(snapshot)).filter(String::isNotEmpty).joinToString("\n"))
        services.show(Text.SERVICES.of(context) + "\n" + wording.services(snapshot))
        chosen.show(chosenText)
        val running = state.phase == VehicleHost.Phase.RUNNING
        start.isEnabled = state.phase == VehicleHost.Phase.STOPPED || state.phase == VehicleHost.Phase.FAILED
        stop.isEnabled = running || state.phase == VehicleHost.Phase.CRASHED
        arm.isEnabled = running && !snapshot.armed && snapshot.emergency == null && snapshot.hazards.isEmpty()
        arm.visibility = if (snapshot.armed) View.GONE else View.VISIBLE
        disarm.visibility = if (snapshot.armed) View.VISIBLE else View.GONE
        clear.visibility = if (running && snapshot.emergency != null) View.VISIBLE else View.GONE
        emergency.isEnabled = running
        emergency.alpha = if (running) 1f else PALE
    }

    private fun TextView.show(words: String) {
        if (text.toString() != words) {
            text = words
        }
        visibility = if (words.isEmpty()) View.GONE else View.VISIBLE
    }

    private fun text(sp: Float? = null) = TextView(context).apply {
        setTextColor(palette.text)
        setPadding(pixels(PAD_DP), pixels(PAD_DP) / 2, pixels(PAD_DP), pixels(PAD_DP) / 2)
        sp?.let { textSize = it }
    }

    private fun button(label: Text, description: Text, pressed: () -> Unit) = Button(context).apply {
        text = label.of(context)
        contentDescription = description.of(context)
        isAllCaps = false
        setOnClickListener { pressed() }
    }

    private fun buttons() = row(start, arm, disarm, stop)

    private fun scrolling(vararg views: View) = ScrollView(context).apply {
        addView(column(*views), MATCH_PARENT, WRAP_CONTENT)
        isFillViewport = true
    }

    private fun row(vararg views: View) = LinearLayout(context).apply {
        orientation = LinearLayout.HORIZONTAL
        views.forEach { addView(it, LinearLayout.LayoutParams(0, heightIn(it), 1f)) }
    }

    private fun heightIn(view: View) = if (view is Button) WRAP_CONTENT else MATCH_PARENT

    /** Stacks views vertically; a view with a weight takes the remaining space. */
    private fun column(vararg views: Any) = LinearLayout(context).apply {
        orientation = LinearLayout.VERTICAL
        gravity = Gravity.TOP
        for (each in views) {
            if (each is Pair<*, *>) {
                addView(each.first as View, LinearLayout.LayoutParams(MATCH_PARENT, 0, each.second as Float))
            } else {
                addView(each as View, LinearLayout.LayoutParams(MATCH_PARENT, WRAP_CONTENT))
            }
        }
    }

    private fun pixels(dips: Int) = (dips * dp).toInt()
}
