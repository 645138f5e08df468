package org.u2sa.android.screen

import org.u2sa.android.text.Text
import android.content.Context
import org.u2sa.android.vehicle.VehicleSnapshot
import org.u2sa.android.vehicle.hazardText

/** Formats a snapshot for display. */
internal class Wording(private val context: Context) {
    /** Text description of the track view. */
    fun track(snapshot: VehicleSnapshot): String {
        val motion = snapshot.motion ?: return Text.TRACK_NONE.of(context)
        val goal = snapshot.goals.firstOrNull { it.current }
        val next = goal?.let { Text.TRACK_NEXT.of(context, it.name, metres(motion.place.distanceM(it.place))) }
        return Text.TRACK_DESCRIPTION.of(
            context,
            motion.headingRad?.let { Text.DEGREES.of(context, Math.toDegrees(it)) } ?: Text.UNKNOWN.of(context),
            motion.speedMps?.let { Text.METRES_PER_SECOND.of(context, it) } ?: Text.UNKNOWN.of(context),
            motion.sigmaM?.let(::metres) ?: Text.UNKNOWN.of(context),
            next ?: Text.TRACK_NO_GOAL.of(context),
        )
    }

    fun metres(metres: Double): String = Text.METRES.of(context, metres)

    /** All batteries with a reading. */
    fun batteries(snapshot: VehicleSnapshot): String = snapshot.batteries.entries.joinToString("\n") { (name, battery) ->
        listOfNotNull(
            battery.volts?.let { Text.BATTERY_VOLTS.of(context, name, it) },
            battery.percent?.let { Text.BATTERY_PERCENT.of(context, name, it) },
        ).joinToString(", ")
    }

    fun services(snapshot: VehicleSnapshot): String =
        if (snapshot.services.isEmpty()) {
            Text.SERVICES_NONE.of(context)
        } else {
            snapshot.services.joinToString("\n") { line ->
                (if (line.healthy) "✓ " else "✗ ") + Text.SERVICE_LINE.of(context, line.name, line.words)
            }
        }

    /** Faults and reasons against arming; empty if none. */
    fun warnings(snapshot: VehicleSnapshot, boardTrouble: String): String = buildList {
        snapshot.hazards.forEach { add(hazardText(it).of(context)) }
        if (boardTrouble.isNotEmpty()) {
            add(Text.BOARD_TROUBLE.of(context, boardTrouble))
        }
        snapshot.armingReasons.forEach { add(Text.NOT_ARMED.of(context, it)) }
    }.joinToString("\n")
}
