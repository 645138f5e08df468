package org.u2sa.android.vehicle

import android.content.BroadcastReceiver
import android.content.Context
import android.content.Intent
import android.content.IntentFilter
import android.os.BatteryManager
import android.os.Build
import android.os.PowerManager

private const val PERCENT = 100.0

/** Condition of this phone; listens for battery changes until [close]. */
class AndroidPhoneCondition(private val context: Context) : PhoneCondition, AutoCloseable {
    @Volatile private var batteryPercent: Double? = null
    @Volatile private var charging = false

    private val power = context.getSystemService(Context.POWER_SERVICE) as PowerManager
    private val battery = object : BroadcastReceiver() {
        override fun onReceive(context: Context, intent: Intent) = take(intent)
    }

    init {
        context.registerReceiver(battery, IntentFilter(Intent.ACTION_BATTERY_CHANGED))?.let(::take) // sticky broadcast: delivers the current state immediately
    }

    private fun take(intent: Intent) {
        val level = intent.getIntExtra(BatteryManager.EXTRA_LEVEL, -1)
        val scale = intent.getIntExtra(BatteryManager.EXTRA_SCALE, -1)
        batteryPercent = if (level >= 0 && scale > 0) PERCENT * level / scale else null
        charging = intent.getIntExtra(BatteryManager.EXTRA_PLUGGED, 0) != 0
    }

    override fun read() = PhoneCondition.Reading(batteryPercent, charging, heat())

    /** Polled rather than listened to, because phones without a thermometer throw on registration. */
    private fun heat(): PhoneCondition.Heat? =
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q) {
            PhoneCondition.Heat.entries.getOrNull(power.currentThermalStatus)
        } else {
            null
        }

    override fun close() = context.unregisterReceiver(battery)
}
