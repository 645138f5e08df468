package org.u2sa.android.vehicle

import android.app.Notification
import android.app.NotificationChannel
import android.app.NotificationManager
import android.app.PendingIntent
import android.content.Context
import android.content.Intent
import android.graphics.drawable.Icon
import org.u2sa.android.text.Text

private const val CHANNEL = "vehicle"

/** The foreground-service notification: vehicle status and an emergency stop. */
internal class VehicleNotification(private val context: Context) {
    private val manager = context.getSystemService(Context.NOTIFICATION_SERVICE) as NotificationManager

    init {
        val channel = NotificationChannel(CHANNEL, Text.CHANNEL_VEHICLE.of(context), NotificationManager.IMPORTANCE_LOW)
        channel.description = Text.CHANNEL_VEHICLE_DESCRIPTION.of(context)
        manager.createNotificationChannel(channel)
    }

    /** @param running whether a vehicle is running */
    fun of(words: String, running: Boolean): Notification {
        val icon = context.resources.getIdentifier("ic_vehicle_small", "drawable", context.packageName)
        val builder = Notification.Builder(context, CHANNEL)
            .setSmallIcon(icon)
            .setContentTitle(Text.APP_NAME.of(context))
            .setContentText(words)
            .setStyle(Notification.BigTextStyle().bigText(words))
            .setOngoing(running)
            .setOnlyAlertOnce(true)
            .setCategory(Notification.CATEGORY_SERVICE)
            .setVisibility(Notification.VISIBILITY_PUBLIC) // shows the stop button on the lock screen
            .setContentIntent(open())
        if (running) {
            val stop = Icon.createWithResource(context, icon)
            builder.addAction(Notification.Action.Builder(stop, Text.EMERGENCY_STOP.of(context), emergencyStop()).build())
        }
        return builder.build()
    }

    fun show(words: String, running: Boolean) = manager.notify(ID, of(words, running))

    private fun open() = PendingIntent.getActivity(
        context, 0, context.packageManager.getLaunchIntentForPackage(context.packageName), PendingIntent.FLAG_IMMUTABLE,
    )

    private fun emergencyStop() = PendingIntent.getService(
        context,
        1,
        Intent(context, VehicleService::class.java).setAction(VehicleService.EMERGENCY_STOP),
        PendingIntent.FLAG_IMMUTABLE,
    )

    companion object {
        /** The only notification. */
        const val ID = 1
    }
}
