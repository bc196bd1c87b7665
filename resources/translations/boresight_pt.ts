<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt">
<context>
    <name>Axes</name>
    <message>
        <source>azimuth</source>
        <translation>azimute</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>elevação</translation>
    </message>
    <message>
        <source>AZ</source>
        <translation>AZ</translation>
    </message>
    <message>
        <source>EL</source>
        <translation>EL</translation>
    </message>
</context>
<context>
    <name>CableText</name>
    <message>
        <source>travel %1…%2</source>
        <translation>curso %1…%2</translation>
    </message>
    <message>
        <source>cable %1</source>
        <translation>cabo %1</translation>
    </message>
    <message>
        <source>Its travel is from %1 to %2.</source>
        <translation>O seu curso vai de %1 a %2.</translation>
    </message>
    <message>
        <source>wrap unknown</source>
        <translation>volta desconhecida</translation>
    </message>
    <message>
        <source>The cable wrap is unknown.</source>
        <translation>A volta do cabo é desconhecida.</translation>
    </message>
    <message>
        <source>The position of the cable is unknown.</source>
        <translation>A posição do cabo é desconhecida.</translation>
    </message>
    <message>
        <source>The azimuth cable is at %1.</source>
        <translation>O cabo de azimute está em %1.</translation>
    </message>
    <message>
        <source>The nearer end is %1 away.</source>
        <translation>O fim mais próximo está a %1.</translation>
    </message>
    <message>
        <source>It ends at %1 in %2.</source>
        <translation>Termina em %1 dentro de %2.</translation>
    </message>
    <message>
        <source>end in %1, %2</source>
        <translation>fim em %1, %2</translation>
    </message>
    <message>
        <source>at the end</source>
        <translation>no fim</translation>
    </message>
    <message>
        <source>It is at the end.</source>
        <translation>Está no fim.</translation>
    </message>
</context>
<context>
    <name>CalibrationWords</name>
    <message>
        <source>Hard iron %1, soft iron %2, readings scatter by %3.</source>
        <translation>Ferro duro %1, ferro macio %2, dispersão das leituras %3.</translation>
    </message>
    <message>
        <source>No tilt: %1</source>
        <translation>Sem inclinação: %1</translation>
    </message>
    <message>
        <source>azimuth offset</source>
        <translation>desvio de azimute</translation>
    </message>
    <message>
        <source>elevation offset</source>
        <translation>desvio de elevação</translation>
    </message>
    <message>
        <source>tilt to the north</source>
        <translation>inclinação para norte</translation>
    </message>
    <message>
        <source>tilt to the east</source>
        <translation>inclinação para leste</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>colimação</translation>
    </message>
    <message>
        <source>axes not square</source>
        <translation>eixos sem esquadria</translation>
    </message>
    <message>
        <source>gravity sag</source>
        <translation>flexão pelo peso</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Lua</translation>
    </message>
    <message>
        <source>sets %1</source>
        <translation>põe-se %1</translation>
    </message>
    <message>
        <source>below the horizon, rises %1</source>
        <translation>abaixo do horizonte, nasce %1</translation>
    </message>
    <message>
        <source>below the horizon</source>
        <translation>abaixo do horizonte</translation>
    </message>
    <message>
        <source>curve of the sensor</source>
        <translation>curva do sensor</translation>
    </message>
    <message>
        <source>no term changes by 0.01°</source>
        <translation>nenhum termo muda 0.01°</translation>
    </message>
    <message>
        <source>, χ² %1</source>
        <translation>, χ² %1</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 de %2 pontos</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 ponto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 pontos</translation>
    </message>
    <message>
        <source>1 term</source>
        <translation>1 termo</translation>
    </message>
    <message>
        <source>%1 terms</source>
        <translation>%1 termos</translation>
    </message>
    <message>
        <source>rms %1 → %2</source>
        <translation>rms %1 → %2</translation>
    </message>
    <message>
        <source>, points: rms %1 → %2</source>
        <translation>, pontos: rms %1 → %2</translation>
    </message>
    <message>
        <source>north stays</source>
        <translation>o norte mantém-se</translation>
    </message>
    <message>
        <source>Nothing proposed yet</source>
        <translation>Ainda não há proposta</translation>
    </message>
    <message>
        <source>No fit: %1</source>
        <translation>Sem ajuste: %1</translation>
    </message>
    <message>
        <source>The azimuth axis leans by %1 ± %2 towards %3. At 0° of the elevation axis the sensor reports %4.</source>
        <translation>O eixo de azimute inclina-se %1 ± %2 para %3. A 0° do eixo de elevação o sensor indica %4.</translation>
    </message>
    <message>
        <source>No points yet. Take them in step 3</source>
        <translation>Ainda não há pontos. Tome-os no passo 3</translation>
    </message>
    <message>
        <source>Turning clockwise, the sensor reads %1 more than turning back.</source>
        <translation>No sentido horário o sensor indica mais %1 do que na volta.</translation>
    </message>
    <message>
        <source>Never look into the Sun or along a sight tube. The Sun can burn the feed of a dish. Use the shadow and be quick.</source>
        <translation>Nunca olhe para o Sol nem por um tubo de mira. O Sol pode queimar o alimentador de um prato. Use a sombra e seja rápido.</translation>
    </message>
    <message>
        <source>North %1. The readings cause %2 of the uncertainty. A swing cannot measure the other %3.</source>
        <translation>Norte %1. As leituras causam %2 da incerteza. Uma volta não pode medir os outros %3.</translation>
    </message>
    <message>
        <source>No fit for these points</source>
        <translation>Sem ajuste para estes pontos</translation>
    </message>
    <message>
        <source>%1: rms now %2, with the proposal %3, with the best fit of these points %5 (%4)</source>
        <translation>%1: rms agora %2, com a proposta %3, com o melhor ajuste destes pontos %5 (%4)</translation>
    </message>
    <message>
        <source>%1: rms now %2, with the best fit of these points %4 (%3)</source>
        <translation>%1: rms agora %2, com o melhor ajuste destes pontos %4 (%3)</translation>
    </message>
    <message>
        <source>, each point predicted from the others %1</source>
        <translation>, cada ponto previsto a partir dos outros %1</translation>
    </message>
</context>
<context>
    <name>ClockWords</name>
    <message>
        <source>A time source sets the clock of the station.</source>
        <translation>Uma fonte de tempo acerta o relógio da estação.</translation>
    </message>
    <message>
        <source>%1 That is %2 for %3.</source>
        <translation>%1 São %2 para %3.</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>não acertado</translation>
    </message>
    <message>
        <source>±%1 = %2</source>
        <translation>±%1 = %2</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>No time source sets the clock of the station. Set up NTP or GPS.</source>
        <translation>Nenhuma fonte de tempo acerta o relógio da estação. Configure NTP ou GPS.</translation>
    </message>
    <message>
        <source>%1 A satellite 420 km up moves 1° in a second.</source>
        <translation>%1 Um satélite a 420 km de altitude move-se 1° num segundo.</translation>
    </message>
    <message>
        <source>A time source sets the clock of the station. It reports an error of %1.</source>
        <translation>Uma fonte de tempo acerta o relógio da estação. Indica um erro de %1.</translation>
    </message>
    <message>
        <source>1 s = %1</source>
        <translation>1 s = %1</translation>
    </message>
    <message>
        <source>set by %1 s</source>
        <translation>acertado em %1 s</translation>
    </message>
    <message>
        <source>The clock of the station was set by %1 s. Boresight still uses the old time, which is shown here. To change this, press Use new time on the alarm.</source>
        <translation>O relógio da estação foi acertado em %1 s. O Boresight ainda usa a hora antiga, que é mostrada aqui. Para mudar isto, prima &quot;Usar nova hora&quot; no alarme.</translation>
    </message>
    <message>
        <source>%1 An error of one second is %2 for %3.</source>
        <translation>%1 Um erro de um segundo são %2 para %3.</translation>
    </message>
</context>
<context>
    <name>DriveCheckWords</name>
    <message>
        <source>The bus is released to other tools</source>
        <translation>O barramento está entregue a outras ferramentas</translation>
    </message>
    <message>
        <source>reading the drives</source>
        <translation>lendo os acionamentos</translation>
    </message>
    <message>
        <source>writing the drives</source>
        <translation>a escrever nos acionamentos</translation>
    </message>
    <message>
        <source>The drives have been read</source>
        <translation>Os acionamentos foram lidos</translation>
    </message>
    <message>
        <source>The drives have not been read</source>
        <translation>Os acionamentos não foram lidos</translation>
    </message>
    <message>
        <source>Nothing may move: %1</source>
        <translation>Nada pode mover-se: %1</translation>
    </message>
    <message>
        <source>Nothing moves until you take it back. Then Boresight reads the drives again</source>
        <translation>Nada se move até o retomar. Depois o Boresight lê de novo os acionamentos</translation>
    </message>
    <message>
        <source>Ready to move, drives switched on</source>
        <translation>Pronto a mover, acionamentos ligados</translation>
    </message>
    <message>
        <source>Ready to move, drives switched off</source>
        <translation>Pronto a mover, acionamentos desligados</translation>
    </message>
    <message>
        <source>Nothing moves until you press Re-arm</source>
        <translation>Nada se move até premir Rearmar</translation>
    </message>
    <message>
        <source>The azimuth drive is switched off, the elevation drive is on</source>
        <translation>O acionamento de azimute está desligado, o de elevação está ligado</translation>
    </message>
    <message>
        <source>The elevation drive is switched off, the azimuth drive is on</source>
        <translation>O acionamento de elevação está desligado, o de azimute está ligado</translation>
    </message>
</context>
<context>
    <name>EndSwitchWords</name>
    <message>
        <source>AZ upper end</source>
        <translation>AZ fim superior</translation>
    </message>
    <message>
        <source>AZ lower end</source>
        <translation>AZ fim inferior</translation>
    </message>
    <message>
        <source>EL upper end</source>
        <translation>EL fim superior</translation>
    </message>
    <message>
        <source>EL lower end</source>
        <translation>EL fim inferior</translation>
    </message>
    <message>
        <source>%1: pressed (%2)</source>
        <translation>%1: premido (%2)</translation>
    </message>
    <message>
        <source>%1: free (%2)</source>
        <translation>%1: livre (%2)</translation>
    </message>
    <message>
        <source>%1: not read (%2)</source>
        <translation>%1: não lido (%2)</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>az %1  el %2</source>
        <translation>az %1  el %2</translation>
    </message>
</context>
<context>
    <name>GpredictSettings</name>
    <message>
        <source>address of this computer</source>
        <translation>endereço deste computador</translation>
    </message>
    <message>
        <source>Gpredict: rotctld does not listen</source>
        <translation>Gpredict: o rotctld não escuta</translation>
    </message>
    <message>
        <source>Gpredict: Host %1, Port %2, Az type %3</source>
        <translation>Gpredict: Host %1, Port %2, Az type %3</translation>
    </message>
    <message>
        <source>Gpredict: Edit &gt; Preferences &gt; Interfaces &gt; Rotators &gt; Add New
Host: %1
Port: %2
Az type: %3
Min Az: %4  Max Az: %5  Min El: 0  Max El: 90
Antenna Control: Cycle 1000 msec, Threshold 0.1 deg
</source>
        <translation>Gpredict: Edit &gt; Preferences &gt; Interfaces &gt; Rotators &gt; Add New
Host: %1
Port: %2
Az type: %3
Min Az: %4  Max Az: %5  Min El: 0  Max El: 90
Antenna Control: Cycle 1000 msec, Threshold 0.1 deg
</translation>
    </message>
</context>
<context>
    <name>GuideWords</name>
    <message>
        <source>Connect</source>
        <translation>Ligação</translation>
    </message>
    <message>
        <source>Protect</source>
        <translation>Proteção</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Curso</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nível</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Local</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>Turning: which motor turns which axis, and which way?</source>
        <translation>Sentido: que motor move que eixo, e para que lado?</translation>
    </message>
    <message>
        <source>Travel: how far may each axis and its cable go?</source>
        <translation>Curso: até onde podem ir cada eixo e o seu cabo?</translation>
    </message>
    <message>
        <source>Level: where is elevation 0°?</source>
        <translation>Nível: onde fica a elevação 0°?</translation>
    </message>
    <message>
        <source>North: where is azimuth 0°?</source>
        <translation>Norte: onde fica o azimute 0°?</translation>
    </message>
    <message>
        <source>Site: where does the mount stand?</source>
        <translation>Local: onde está a montagem?</translation>
    </message>
    <message>
        <source>The drives have not been read.</source>
        <translation>Os acionamentos não foram lidos.</translation>
    </message>
    <message>
        <source>The directions are not confirmed.</source>
        <translation>Os sentidos não estão confirmados.</translation>
    </message>
    <message>
        <source>No site has been set.</source>
        <translation>Nenhum local foi definido.</translation>
    </message>
    <message>
        <source>The mount does not answer.</source>
        <translation>A montagem não responde.</translation>
    </message>
    <message>
        <source>The cable wrap of the %1 is unknown. Press Ctrl+9 to enter it.</source>
        <translation>A volta do cabo do %1 é desconhecida. Prima Ctrl+9 para a indicar.</translation>
    </message>
    <message>
        <source>No program can connect, because rotctld does not listen.</source>
        <translation>Nenhum programa se pode ligar, porque o rotctld não está à escuta.</translation>
    </message>
    <message>
        <source>Nobody has confirmed north.</source>
        <translation>Ninguém confirmou o norte.</translation>
    </message>
    <message>
        <source>Nobody has confirmed this step.</source>
        <translation>Ninguém confirmou este passo.</translation>
    </message>
    <message>
        <source>A step needs you.</source>
        <translation>Um passo precisa de si.</translation>
    </message>
    <message>
        <source>Not every step is done.</source>
        <translation>Nem todos os passos estão feitos.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Pronto</translation>
    </message>
    <message>
        <source>Ready: first pass</source>
        <translation>Pronto: primeira passagem</translation>
    </message>
    <message>
        <source>done</source>
        <translation>feito</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>saltado</translation>
    </message>
    <message>
        <source>needs you</source>
        <translation>precisa de si</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>por fazer</translation>
    </message>
    <message>
        <source>The bus is released. Press Take bus back on the page Drives.</source>
        <translation>O barramento está libertado. Prima Retomar barramento na página Acionamentos.</translation>
    </message>
    <message>
        <source>No program is connected.</source>
        <translation>Nenhum programa está ligado.</translation>
    </message>
    <message>
        <source>I have checked: the ends of the travel are right</source>
        <translation>Verifiquei: os fins do curso estão certos como estão</translation>
    </message>
    <message>
        <source>I have checked: elevation 0° is level</source>
        <translation>Verifiquei: elevação 0° é horizontal</translation>
    </message>
    <message>
        <source>I have checked: north is right</source>
        <translation>Verifiquei: o norte está certo como está</translation>
    </message>
    <message>
        <source>The program that tracks the satellites is set up</source>
        <translation>O programa que segue os satélites está configurado</translation>
    </message>
    <message>
        <source>Protect: are the safety settings of each drive right?</source>
        <translation>Proteção: as definições de segurança de cada acionamento estão certas?</translation>
    </message>
    <message>
        <source>Client: which program tracks the satellites?</source>
        <translation>Cliente: que programa segue os satélites?</translation>
    </message>
    <message>
        <source>Connect: what turns the mount?</source>
        <translation>Ligação: o que move a montagem?</translation>
    </message>
    <message>
        <source>Boresight is reading the drives.</source>
        <translation>O Boresight está a ler os acionamentos.</translation>
    </message>
    <message>
        <source>The position of the %1 is unknown. Press Ctrl+9 to enter it.</source>
        <translation>A posição do %1 é desconhecida. Prima Ctrl+9 para a indicar.</translation>
    </message>
</context>
<context>
    <name>HorizonFiles</name>
    <message>
        <source>%1 points read</source>
        <translation>%1 pontos lidos</translation>
    </message>
    <message>
        <source>The file is too long for a horizon.</source>
        <translation>O ficheiro é longo demais para um horizonte.</translation>
    </message>
    <message>
        <source>%1 points read. %2 lower points at the same azimuth were left out</source>
        <translation>%1 pontos lidos. %2 pontos mais baixos no mesmo azimute foram omitidos</translation>
    </message>
</context>
<context>
    <name>LinkLabels</name>
    <message>
        <source>%1 off</source>
        <translation>%1 off</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 caído</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 fora</translation>
    </message>
    <message>
        <source>%1 silent</source>
        <translation>%1 mudo</translation>
    </message>
    <message>
        <source>%1 fault</source>
        <translation>%1 falha</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>%1 tarde</translation>
    </message>
    <message>
        <source>Sensor lost</source>
        <translation>Sensor perdido</translation>
    </message>
    <message>
        <source>Sensor differs</source>
        <translation>Sensor difere</translation>
    </message>
    <message>
        <source>Sensor late</source>
        <translation>Sensor atrasado</translation>
    </message>
    <message>
        <source>Sensor silent</source>
        <translation>Sensor mudo</translation>
    </message>
    <message>
        <source>Sensor awaited</source>
        <translation>Sensor esperado</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>%1: %2 values, %3 refused, %4 outliers</source>
        <translation>%1: %2 valores, %3 recusados, %4 discrepantes</translation>
    </message>
    <message>
        <source>TX output failed</source>
        <translation>Saída TX falhou</translation>
    </message>
    <message>
        <source>TX on</source>
        <translation>TX ligado</translation>
    </message>
    <message>
        <source>TX off</source>
        <translation>TX desligado</translation>
    </message>
    <message>
        <source>The output %1 is on only while the beam is less than %2 from the target.</source>
        <translation>A saída %1 só está ligada enquanto o feixe está a menos de %2 do alvo.</translation>
    </message>
    <message>
        <source>%1: %2 frames sent, %3 received, %4 dropped, %5 bus errors</source>
        <translation>%1: %2 quadros enviados, %3 recebidos, %4 perdidos, %5 erros no barramento</translation>
    </message>
    <message>
        <source>Line to the mount</source>
        <translation>Ligação com a montagem</translation>
    </message>
    <message>
        <source>Azimuth drive</source>
        <translation>Acionamento de azimute</translation>
    </message>
    <message>
        <source>AZ</source>
        <translation>AZ</translation>
    </message>
    <message>
        <source>Elevation drive</source>
        <translation>Acionamento de elevação</translation>
    </message>
    <message>
        <source>EL</source>
        <translation>EL</translation>
    </message>
    <message>
        <source>Orientation sensor</source>
        <translation>Sensor de orientação</translation>
    </message>
    <message>
        <source>Transmit output</source>
        <translation>Saída de emissão</translation>
    </message>
    <message>
        <source>Brake failed</source>
        <translation>Travão falhou</translation>
    </message>
    <message>
        <source>Brake set</source>
        <translation>Travão aplicado</translation>
    </message>
    <message>
        <source>Brake opens</source>
        <translation>Travão a abrir</translation>
    </message>
    <message>
        <source>Brake open</source>
        <translation>Travão aberto</translation>
    </message>
    <message>
        <source>Brake closes</source>
        <translation>Travão a fechar</translation>
    </message>
    <message>
        <source>Brake</source>
        <translation>Travão</translation>
    </message>
    <message>
        <source>The output %1 is on while the brake is open. Nothing moves before the brake is open.</source>
        <translation>A saída %1 está ligada enquanto o travão está aberto. Nada se move antes de o travão estar aberto.</translation>
    </message>
    <message>
        <source>%1 switch</source>
        <translation>%1 no fim</translation>
    </message>
</context>
<context>
    <name>MotorWords</name>
    <message>
        <source>%1 motor starts in the last minute, %2 in total</source>
        <translation>%1 arranques do motor no último minuto, %2 no total</translation>
    </message>
    <message>
        <source>The axis coasts %1 beyond its target</source>
        <translation>O eixo desliza %1 para além do alvo</translation>
    </message>
    <message>
        <source>The axis stands only at steps of %1</source>
        <translation>O eixo só para em passos de %1</translation>
    </message>
</context>
<context>
    <name>ParkWords</name>
    <message>
        <source>Move park to %1</source>
        <translation>Mover o estacionamento para %1</translation>
    </message>
    <message>
        <source>Move park to %1 / %2</source>
        <translation>Mover o estacionamento para %1 / %2</translation>
    </message>
</context>
<context>
    <name>PassWords</name>
    <message>
        <source>up</source>
        <translation>visível</translation>
    </message>
    <message>
        <source>%1, number %2</source>
        <translation>%1, número %2</translation>
    </message>
    <message>
        <source>rises %1Z at %2</source>
        <translation>nasce às %1Z a %2</translation>
    </message>
    <message>
        <source>highest %1Z, %2 up</source>
        <translation>mais alto às %1Z, a %2</translation>
    </message>
    <message>
        <source>sets %1Z at %2</source>
        <translation>põe-se às %1Z a %2</translation>
    </message>
    <message>
        <source>hidden for %1 by the limits</source>
        <translation>oculto durante %1 pelos limites</translation>
    </message>
    <message>
        <source>in sunlight</source>
        <translation>ao sol</translation>
    </message>
    <message>
        <source>in the shadow of the Earth</source>
        <translation>na sombra da Terra</translation>
    </message>
    <message>
        <source>enters the shadow %1Z</source>
        <translation>entra na sombra %1Z</translation>
    </message>
    <message>
        <source>leaves the shadow %1Z</source>
        <translation>sai da sombra %1Z</translation>
    </message>
    <message>
        <source>in the shadow %1Z to %2Z</source>
        <translation>na sombra %1Z a %2Z</translation>
    </message>
    <message>
        <source>in sunlight %1Z to %2Z</source>
        <translation>ao sol %1Z a %2Z</translation>
    </message>
    <message>
        <source>number %1, from %2 to %3</source>
        <translation>número %1, de %2 a %3</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, de %2 a %3</translation>
    </message>
    <message>
        <source>hidden for %1</source>
        <translation>oculto durante %1</translation>
    </message>
    <message>
        <source>no</source>
        <translation>não</translation>
    </message>
    <message>
        <source>all</source>
        <translation>toda</translation>
    </message>
    <message>
        <source>%1 d, too old</source>
        <translation>%1 d, demasiado antigos</translation>
    </message>
    <message>
        <source>%1 d</source>
        <translation>%1 d</translation>
    </message>
    <message>
        <source>unwraps the cable, which loses %1</source>
        <translation>desenrola o cabo, o que perde %1</translation>
    </message>
    <message>
        <source>The cable has room for all of the pass.</source>
        <translation>O cabo chega para toda a passagem.</translation>
    </message>
    <message>
        <source>The cable ends during the pass.</source>
        <translation>O cabo acaba durante a passagem.</translation>
    </message>
    <message>
        <source>The cable ends %1 times during the pass.</source>
        <translation>O cabo acaba %1 vezes durante a passagem.</translation>
    </message>
    <message>
        <source>Boresight unwraps it by 360° there and loses %1 of the pass.</source>
        <translation>O Boresight desenrola-o aí 360° e perde %1 da passagem.</translation>
    </message>
    <message>
        <source>seen %1 UTC</source>
        <translation>vista %1 UTC</translation>
    </message>
    <message>
        <source>elements %1 days old: expected error %2 s or %3, more than half the beam of %4</source>
        <translation>elementos com %1 dias: erro esperado %2 s ou %3, mais de metade do feixe de %4</translation>
    </message>
    <message>
        <source>elements %1 days old: expected error %2 s or %3, beam %4</source>
        <translation>elementos com %1 dias: erro esperado %2 s ou %3, feixe %4</translation>
    </message>
    <message>
        <source>elements %1 d old: error %2 s, %3, beam %4, too old</source>
        <translation>elementos com %1 d: erro %2 s, %3, feixe %4, demasiado antigos</translation>
    </message>
    <message>
        <source>elements %1 d old: error %2 s, %3, beam %4</source>
        <translation>elementos com %1 d: erro %2 s, %3, feixe %4</translation>
    </message>
    <message>
        <source>The azimuth turns less than 360°, so the mount does not track all of the pass.</source>
        <translation>O azimute roda menos de 360°, por isso a montagem não segue a passagem toda.</translation>
    </message>
    <message>
        <source>over the top</source>
        <translation>pelo outro lado</translation>
    </message>
    <message>
        <source>goes over the top, because the cable ends. Nothing is lost</source>
        <translation>passa pelo outro lado do zénite, porque o cabo acaba. Nada se perde</translation>
    </message>
    <message>
        <source>Boresight tracks the pass over the top, with elevations above 90°, and loses nothing.</source>
        <translation>O Boresight segue a passagem pelo outro lado do zénite, com elevações acima de 90°, e não perde nada.</translation>
    </message>
</context>
<context>
    <name>PlotPicture</name>
    <message>
        <source>Sky plot</source>
        <translation>Gráfico do céu</translation>
    </message>
</context>
<context>
    <name>ProfileChange</name>
    <message>
        <source>Another panel has changes that are not applied. Apply or revert them first.</source>
        <translation>Outro painel tem alterações por aplicar. Aplique-as ou reverta-as primeiro.</translation>
    </message>
    <message>
        <source>The change to the bus %1 is not in force yet. Press Reconnect first (tab Mount, Profile).</source>
        <translation>A mudança para o barramento %1 ainda não está em vigor. Prima Reconectar primeiro (separador Montagem, Perfil).</translation>
    </message>
</context>
<context>
    <name>RangeWords</name>
    <message>
        <source>%1 km, %2 km/s</source>
        <translation>%1 km, %2 km/s</translation>
    </message>
    <message>
        <source>%1 Hz/MHz</source>
        <translation>%1 Hz/MHz</translation>
    </message>
    <message>
        <source>%1, Doppler %2</source>
        <translation>%1, Doppler %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>RegionEdit</name>
    <message>
        <source>keep-out %1</source>
        <translation>zona proibida %1</translation>
    </message>
    <message>
        <source>lowest elevation
%1</source>
        <translation>menor elevação
%1</translation>
    </message>
    <message>
        <source>highest elevation
%1</source>
        <translation>maior elevação
%1</translation>
    </message>
    <message>
        <source>horizon
az %1
el %2</source>
        <translation>horizonte
az %1
el %2</translation>
    </message>
    <message>
        <source>%1
az %2
el %3</source>
        <translation>%1
az %2
el %3</translation>
    </message>
    <message>
        <source>%1
of the axis</source>
        <translation>%1
do eixo</translation>
    </message>
    <message>
        <source>azimuth axis limit
from %1</source>
        <translation>limite do eixo de azimute
desde %1</translation>
    </message>
    <message>
        <source>azimuth axis limit
to %1</source>
        <translation>limite do eixo de azimute
até %1</translation>
    </message>
</context>
<context>
    <name>ReplayTape</name>
    <message>
        <source>%1 ticks were not recorded. The disk was too slow or full.</source>
        <translation>%1 instantes não foram gravados. O disco estava demasiado lento ou cheio.</translation>
    </message>
    <message>
        <source>The recording has no end mark. The replay ends with the last whole block. Boresight still writes the file, or was interrupted.</source>
        <translation>A gravação não tem marca de fim. A reprodução termina no último bloco completo. O Boresight ainda está a escrever o ficheiro, ou foi interrompido.</translation>
    </message>
    <message>
        <source>The file is damaged. The replay has everything that could be read:</source>
        <translation>O ficheiro está danificado. A reprodução tem tudo o que pôde ser lido:</translation>
    </message>
    <message>
        <source>The recording has no ticks, so sky and charts are empty.</source>
        <translation>A gravação não tem instantes, por isso o céu e os gráficos estão vazios.</translation>
    </message>
    <message>
        <source>Further damage: %1.</source>
        <translation>Outros danos: %1.</translation>
    </message>
</context>
<context>
    <name>SettingWords</name>
    <message>
        <source>Mount</source>
        <translation>Montagem</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Barramento</translation>
    </message>
    <message>
        <source>Azimuth axis</source>
        <translation>Eixo de azimute</translation>
    </message>
    <message>
        <source>Elevation axis</source>
        <translation>Eixo de elevação</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Controlo</translation>
    </message>
    <message>
        <source>Limits of operation</source>
        <translation>Limites de operação</translation>
    </message>
    <message>
        <source>Park and presets</source>
        <translation>Estacionamento e predefinições</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Local</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>rotctld server</source>
        <translation>Servidor rotctld</translation>
    </message>
    <message>
        <source>Supervision</source>
        <translation>Supervisão</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Recuperação</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>Orientation sensor</source>
        <translation>Sensor de orientação</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>Broker MQTT</translation>
    </message>
    <message>
        <source>Pointing model</source>
        <translation>Modelo de apontamento</translation>
    </message>
    <message>
        <source>Gpredict</source>
        <translation>Gpredict</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Received power</source>
        <translation>Potência recebida</translation>
    </message>
    <message>
        <source>lowest azimuth</source>
        <translation>azimute mínimo</translation>
    </message>
    <message>
        <source>highest azimuth</source>
        <translation>azimute máximo</translation>
    </message>
    <message>
        <source>lowest elevation</source>
        <translation>elevação mínima</translation>
    </message>
    <message>
        <source>highest elevation</source>
        <translation>elevação máxima</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>horizonte</translation>
    </message>
    <message>
        <source>keep-outs</source>
        <translation>setores proibidos</translation>
    </message>
    <message>
        <source>presets</source>
        <translation>predefinições</translation>
    </message>
    <message>
        <source>site</source>
        <translation>local</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number.</source>
        <translation>&quot;%1&quot; não é um número inteiro.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number. Type it with a decimal point, for example 113.5.</source>
        <translation>&quot;%1&quot; não é um número. Escreva-o com ponto decimal, por exemplo 113.5.</translation>
    </message>
    <message>
        <source>park azimuth</source>
        <translation>azimute de estacionamento</translation>
    </message>
    <message>
        <source>park elevation</source>
        <translation>elevação de estacionamento</translation>
    </message>
    <message>
        <source>Satellites</source>
        <translation>Satélites</translation>
    </message>
    <message>
        <source>Moon by WSJT-X</source>
        <translation>Lua pelo WSJT-X</translation>
    </message>
    <message>
        <source>Schedule of passes</source>
        <translation>Agenda de passagens</translation>
    </message>
    <message>
        <source>watch list</source>
        <translation>lista da agenda</translation>
    </message>
    <message>
        <source>favourites and notes</source>
        <translation>favoritos e notas</translation>
    </message>
    <message>
        <source>antennas</source>
        <translation>antenas</translation>
    </message>
    <message>
        <source>Balloon or rocket</source>
        <translation>Balão ou foguetão</translation>
    </message>
    <message>
        <source>Transmit on target</source>
        <translation>Transmitir só no alvo</translation>
    </message>
    <message>
        <source>Further listeners</source>
        <translation>Outras escutas</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vento</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>não definido</translation>
    </message>
    <message>
        <source>Switched motors</source>
        <translation>Motores ligados e desligados</translation>
    </message>
    <message>
        <source>Brake</source>
        <translation>Travão</translation>
    </message>
    <message>
        <source>End switches</source>
        <translation>Fins de curso</translation>
    </message>
    <message>
        <source>Third axis</source>
        <translation>Terceiro eixo</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Clientes</translation>
    </message>
    <message>
        <source>Recordings of passes</source>
        <translation>Gravações de passagens</translation>
    </message>
</context>
<context>
    <name>SkyBodies</name>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Lua</translation>
    </message>
</context>
<context>
    <name>SkyItems</name>
    <message>
        <source>az %1</source>
        <translation>az %1</translation>
    </message>
    <message>
        <source>MAGNIFIED ×%1</source>
        <translation>AMPLIADO ×%1</translation>
    </message>
</context>
<context>
    <name>SkyLabels</name>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>E</source>
        <translation>L</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>W</source>
        <translation>O</translation>
    </message>
</context>
<context>
    <name>SkyLegend</name>
    <message>
        <source>actual</source>
        <translation>real</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>comandado</translation>
    </message>
    <message>
        <source>target</source>
        <translation>alvo</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>sensor</translation>
    </message>
    <message>
        <source>planned beam</source>
        <translation>feixe planeado</translation>
    </message>
</context>
<context>
    <name>SkyLimits</name>
    <message>
        <source>below %1</source>
        <translation>abaixo de %1</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>acima de %1</translation>
    </message>
    <message>
        <source>out of limits</source>
        <translation>fora dos limites</translation>
    </message>
    <message>
        <source>X %1</source>
        <translation>X %1</translation>
    </message>
    <message>
        <source>Y %1</source>
        <translation>Y %1</translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>commanded</source>
        <translation>comandado</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>real</translation>
    </message>
    <message>
        <source>commanded − actual</source>
        <translation>comandado − real</translation>
    </message>
    <message>
        <source>motor</source>
        <translation>motor</translation>
    </message>
    <message>
        <source>board</source>
        <translation>placa</translation>
    </message>
    <message>
        <source>%1 % of the beam</source>
        <translation>%1 % do feixe</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>maior</translation>
    </message>
    <message>
        <source>low</source>
        <translation>baixa</translation>
    </message>
    <message>
        <source>high</source>
        <translation>alta</translation>
    </message>
    <message>
        <source>board hot</source>
        <translation>placa quente</translation>
    </message>
    <message>
        <source>motor hot</source>
        <translation>motor quente</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posição</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erro</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Torque</translation>
    </message>
    <message>
        <source>q current</source>
        <translation>Corrente q</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Tensão</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>sem dados</translation>
    </message>
    <message>
        <source>%1 %2%3, range %4%3</source>
        <translation>%1 %2%3, intervalo %4%3</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>&apos;%1&apos; cannot be an interface name: at most 15 characters, no space and no &apos;/&apos;</source>
        <translation>&quot;%1&quot; não pode ser o nome de uma interface: no máximo 15 caracteres, sem espaço e sem &quot;/&quot;</translation>
    </message>
    <message>
        <source>bit rate %1 (wanted %2)</source>
        <translation>taxa de bits %1 (esperada %2)</translation>
    </message>
    <message>
        <source>sample point %1 (wanted %2)</source>
        <translation>ponto de amostragem %1 (esperado %2)</translation>
    </message>
    <message>
        <source>CAN-FD off (wanted on)</source>
        <translation>CAN-FD inativo (esperado ativo)</translation>
    </message>
    <message>
        <source>data bit rate %1 (wanted %2)</source>
        <translation>taxa de bits de dados %1 (esperada %2)</translation>
    </message>
    <message>
        <source>data sample point %1 (wanted %2)</source>
        <translation>ponto de amostragem de dados %1 (esperado %2)</translation>
    </message>
    <message>
        <source>wrong bit timing, so the drives may stay silent: %1. Enter `ip link set %2 down`, then `%3`. `ip -details link show %2` shows the values in use</source>
        <translation>temporização de bits errada, por isso os acionamentos podem ficar mudos: %1. Execute `ip link set %2 down`, depois `%3`. `ip -details link show %2` mostra os valores em uso</translation>
    </message>
    <message>
        <source>%1 is a virtual bus. Is `boresightctl simulate --can %1` running?</source>
        <translation>%1 é um barramento virtual. `boresightctl simulate --can %1` está em execução?</translation>
    </message>
    <message>
        <source>Bit timing must be 1M/5M with the sample point at 0.666 in both phases. `ip -details link show %1` shows the values in use, and `packaging/can-up %1` sets them.</source>
        <translation>A temporização de bits tem de ser 1M/5M com o ponto de amostragem em 0.666 nas duas fases. `ip -details link show %1` mostra os valores em uso, e `packaging/can-up %1` define-os.</translation>
    </message>
    <message>
        <source>Bit timing must be 1M/5M with the sample point at 0.666 in both phases. The adapter needs can.bitrate 1000000, can.fd_bitrate 5000000, can.sample_point and can.fd_sample_point 0.666 (its factory settings).</source>
        <translation>A temporização de bits tem de ser 1M/5M com o ponto de amostragem em 0.666 nas duas fases. O adaptador precisa de can.bitrate 1000000, can.fd_bitrate 5000000, can.sample_point e can.fd_sample_point 0.666 (os valores de fábrica).</translation>
    </message>
    <message>
        <source>check the drives&apos; power, the cable and its length, the 120 ohm at both ends, the bit rates and the sample points</source>
        <translation>verifique a alimentação dos acionamentos, o cabo e o seu comprimento, os 120 ohm nas duas pontas, as taxas de bits e os pontos de amostragem</translation>
    </message>
    <message>
        <source>The simulated drives do not answer. Either a fault is simulated, or their ids differ from those in the profile.</source>
        <translation>Os acionamentos simulados não respondem. Ou uma falha está a ser simulada, ou os seus ids são diferentes dos do perfil.</translation>
    </message>
    <message>
        <source>Do the ids in the profile belong to these drives? Release the bus, then `boresightctl scan %1` shows which drives answer.</source>
        <translation>Os ids do perfil são destes acionamentos? Libere o barramento, e `boresightctl scan %1` mostra quais acionamentos respondem.</translation>
    </message>
    <message>
        <source>Do the ids in the profile belong to these drives? `boresightctl scan %1` shows which drives answer.</source>
        <translation>Os ids do perfil são destes acionamentos? `boresightctl scan %1` mostra quais acionamentos respondem.</translation>
    </message>
    <message>
        <source>this kernel&apos;s SocketCAN has no CAN-FD</source>
        <translation>o SocketCAN deste kernel não tem CAN-FD</translation>
    </message>
    <message>
        <source>this kernel has no SocketCAN. Load it with `modprobe can-raw`, or use the adapter as a serial port with --bus fdcanusb:PATH</source>
        <translation>este kernel não tem SocketCAN. Carregue-o com `modprobe can-raw`, ou use o adaptador como porta serial com --bus fdcanusb:CAMINHO</translation>
    </message>
    <message>
        <source>there is no interface %1. Is the adapter plugged in and its driver loaded? `ip -brief link` shows the interfaces</source>
        <translation>não existe a interface %1. O adaptador está ligado e o seu driver carregado? `ip -brief link` mostra as interfaces</translation>
    </message>
    <message>
        <source>%1 is not a CAN interface</source>
        <translation>%1 não é uma interface CAN</translation>
    </message>
    <message>
        <source>%1 is not a CAN-FD interface (mtu %2): `ip link set %1 down`, then `%3`</source>
        <translation>%1 não é uma interface CAN-FD (mtu %2): `ip link set %1 down`, depois `%3`</translation>
    </message>
    <message>
        <source>%1 is in use by %2. End that program, or press &quot;Release bus&quot; on its Drives page</source>
        <translation>%1 está em uso por %2. Encerre esse programa, ou clique em &quot;Liberar barramento&quot; na sua página Acionamentos</translation>
    </message>
    <message>
        <source>%1 is in use by %2. End that program first</source>
        <translation>%1 está em uso por %2. Encerre antes esse programa</translation>
    </message>
    <message>
        <source>%1 is in use by another program (%2). `sudo fuser -v %1` shows which. End that program first</source>
        <translation>%1 está em uso por outro programa (%2). `sudo fuser -v %1` mostra qual. Encerre antes esse programa</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>não é possível abrir %1: %2</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 não está aberto</translation>
    </message>
    <message>
        <source>%1: the adapter accepts no more data. Plug it in again</source>
        <translation>%1: o adaptador já não aceita dados. Desconecte-o e conecte-o de novo</translation>
    </message>
    <message>
        <source>the adapter is not on the bus (&quot;not in BusOn state&quot;). Boresight restarts it once a second. If that does not help, plug it in again</source>
        <translation>o adaptador não está no barramento (&quot;not in BusOn state&quot;). O Boresight reinicia-o uma vez por segundo. Se isso não ajudar, desconecte-o e conecte-o de novo</translation>
    </message>
    <message>
        <source>the adapter refuses a frame: %1. Check its firmware and its can.* settings</source>
        <translation>o adaptador recusa um quadro: %1. Verifique o seu firmware e os seus parâmetros can.*</translation>
    </message>
    <message>
        <source>bus-off after too many errors: check the cable, the 120 ohm at both ends and the bit rate. Boresight restarts the adapter once a second</source>
        <translation>bus-off após muitos erros: verifique o cabo, os 120 ohm nas duas pontas e a taxa de bits. O Boresight reinicia o adaptador uma vez por segundo</translation>
    </message>
    <message>
        <source>the adapter does not confirm our frames (no OK within %1 ms). Is this port an fdcanusb? If so, plug it in again</source>
        <translation>o adaptador não confirma os nossos quadros (nenhum OK em %1 ms). Esta porta é um fdcanusb? Se for, desconecte-o e conecte-o de novo</translation>
    </message>
    <message>
        <source>the kernel&apos;s description of the interface cannot be read</source>
        <translation>não é possível ler a descrição que o kernel dá da interface</translation>
    </message>
    <message>
        <source>%1 (process %2)</source>
        <translation>%1 (processo %2)</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>um programa</translation>
    </message>
    <message>
        <source>%1: no permission to enter its folder</source>
        <translation>%1: sem permissão para entrar na sua pasta</translation>
    </message>
    <message>
        <source>%1 is not a serial port</source>
        <translation>%1 não é uma porta serial</translation>
    </message>
    <message>
        <source>%1: no permission. Install packaging/udev/70-boresight-fdcanusb.rules to /etc/udev/rules.d. Plug the adapter in again. Join the group dialout with `sudo usermod -aG dialout $USER`, then log in again</source>
        <translation>%1: sem permissão. Instale packaging/udev/70-boresight-fdcanusb.rules em /etc/udev/rules.d. Conecte de novo o adaptador. Entre no grupo dialout com `sudo usermod -aG dialout $USER`, depois inicie nova sessão</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 frames sent)</source>
        <translation>%1 (%2 de %3 quadros enviados)</translation>
    </message>
    <message>
        <source>the interface is down. Bring it up with `%1`</source>
        <translation>a interface está inativa. Ative-a com `%1`</translation>
    </message>
    <message>
        <source>bus-off after too many errors: check the cable, the 120 ohm at both ends and the bit rate. With restart-ms set the bus comes back by itself. Otherwise enter `ip link set %1 type can restart`</source>
        <translation>bus-off após muitos erros: verifique o cabo, os 120 ohm nas duas pontas e a taxa de bits. Com restart-ms definido o barramento volta por si. Senão, execute `ip link set %1 type can restart`</translation>
    </message>
    <message>
        <source>the transmit queue is full: another program fills the bus, or %1</source>
        <translation>a fila de envio está cheia: outro programa ocupa o barramento, ou %1</translation>
    </message>
    <message>
        <source>many errors on the bus (error-passive): %1</source>
        <translation>muitos erros no barramento (error-passive): %1</translation>
    </message>
    <message>
        <source>damaged frames on the bus: %1</source>
        <translation>quadros danificados no barramento: %1</translation>
    </message>
    <message>
        <source>more than %1 frames a second on the bus, ten times what two drives need. Another program floods the bus. End that program (`candump %2` shows its identifiers)</source>
        <translation>mais de %1 quadros por segundo no barramento, dez vezes o que dois acionamentos precisam. Outro programa inunda o barramento. Encerre esse programa (`candump %2` mostra os seus identificadores)</translation>
    </message>
    <message>
        <source>Disturbed or wrong wiring at an aux port</source>
        <translation>Fiação perturbada ou errada numa porta aux</translation>
    </message>
    <message>
        <source>A blocked axis, wrong gains, or a trajectory too fast for the torque allowed</source>
        <translation>Eixo bloqueado, ganhos errados ou trajetória rápida demais para o torque permitido</translation>
    </message>
    <message>
        <source>No fault</source>
        <translation>Nenhuma falha</translation>
    </message>
    <message>
        <source>Nothing is wrong</source>
        <translation>Está tudo em ordem</translation>
    </message>
    <message>
        <source>Nothing to do</source>
        <translation>Nada a fazer</translation>
    </message>
    <message>
        <source>The drive&apos;s internal data transfer failed</source>
        <translation>A transferência interna de dados do acionamento falhou</translation>
    </message>
    <message>
        <source>The drive&apos;s internal data transfer lost data</source>
        <translation>A transferência interna de dados do acionamento perdeu dados</translation>
    </message>
    <message>
        <source>The drive&apos;s aux UART received faster than it could read</source>
        <translation>A UART aux do acionamento recebeu mais depressa do que podia ler</translation>
    </message>
    <message>
        <source>The drive&apos;s aux UART received a malformed byte</source>
        <translation>A UART aux do acionamento recebeu um byte malformado</translation>
    </message>
    <message>
        <source>The drive&apos;s aux UART received noise</source>
        <translation>A UART aux do acionamento recebeu ruído</translation>
    </message>
    <message>
        <source>The drive&apos;s aux UART buffer overflowed</source>
        <translation>O buffer da UART aux do acionamento transbordou</translation>
    </message>
    <message>
        <source>The drive&apos;s aux UART received a damaged byte</source>
        <translation>A UART aux do acionamento recebeu um byte danificado</translation>
    </message>
    <message>
        <source>The zero of the current measurement could not be found when enabling</source>
        <translation>Não foi possível achar o zero da medição de corrente ao ativar</translation>
    </message>
    <message>
        <source>The motor was turning while the drive was enabled, or the board is damaged</source>
        <translation>O motor girava enquanto o acionamento era ativado, ou a placa está danificada</translation>
    </message>
    <message>
        <source>The gate driver of the motor outputs switched off</source>
        <translation>O gate driver das saídas do motor desligou-se</translation>
    </message>
    <message>
        <source>The bus voltage rose above servo.max_voltage</source>
        <translation>A tensão do barramento subiu acima de servo.max_voltage</translation>
    </message>
    <message>
        <source>Lower the acceleration, set servo.max_regen_power_W, or add a battery or capacitance</source>
        <translation>Reduza a aceleração, defina servo.max_regen_power_W, ou acrescente uma bateria ou capacidade</translation>
    </message>
    <message>
        <source>The encoder&apos;s readings contradict each other or its port reports an error</source>
        <translation>As leituras do encoder contradizem-se ou a sua porta relata um erro</translation>
    </message>
    <message>
        <source>The magnet came loose, the air gap is wrong, or a wire is broken</source>
        <translation>O ímã soltou-se, o entreferro está errado ou um fio partiu-se</translation>
    </message>
    <message>
        <source>Check magnet, air gap, wiring and the aux port configuration</source>
        <translation>Verifique ímã, entreferro, fiação e configuração da porta aux</translation>
    </message>
    <message>
        <source>The drive has never been calibrated with its motor</source>
        <translation>O acionamento nunca foi calibrado com o seu motor</translation>
    </message>
    <message>
        <source>A new board, or its configuration was reset</source>
        <translation>Uma placa nova, ou a sua configuração foi reposta</translation>
    </message>
    <message>
        <source>Run moteus_tool --calibrate with the axis free to turn</source>
        <translation>Execute moteus_tool --calibrate com o eixo livre para girar</translation>
    </message>
    <message>
        <source>The drive&apos;s control loop did not finish in time</source>
        <translation>O ciclo de controlo do acionamento não terminou a tempo</translation>
    </message>
    <message>
        <source>An error of the drive&apos;s firmware</source>
        <translation>Um erro do firmware do acionamento</translation>
    </message>
    <message>
        <source>The board (75 °C by default) or the motor is too hot</source>
        <translation>A placa (75 °C por padrão) ou o motor está quente demais</translation>
    </message>
    <message>
        <source>Too much torque for too long, or too little cooling</source>
        <translation>Torque a mais por tempo a mais, ou pouca refrigeração</translation>
    </message>
    <message>
        <source>The axis was outside servopos.position_min/max when motion was commanded</source>
        <translation>O eixo estava fora de servopos.position_min/max quando foi comandado movimento</translation>
    </message>
    <message>
        <source>Correct the bounds on the Protection page or bring the axis inside by hand, then re-arm</source>
        <translation>Corrija os limites na página Proteções ou traga o eixo para dentro à mão e depois rearme</translation>
    </message>
    <message>
        <source>The bus voltage fell below 4 V while driving</source>
        <translation>A tensão do barramento caiu abaixo de 4 V em funcionamento</translation>
    </message>
    <message>
        <source>The supply was switched off or cut</source>
        <translation>A alimentação foi desligada ou cortada</translation>
    </message>
    <message>
        <source>Check supply, fuse and cable</source>
        <translation>Verifique a fonte, o fusível e o cabo</translation>
    </message>
    <message>
        <source>Another program wrote to the drive</source>
        <translation>Outro programa escreveu no acionamento</translation>
    </message>
    <message>
        <source>Close the other program, then re-arm</source>
        <translation>Feche o outro programa e depois rearme</translation>
    </message>
    <message>
        <source>No encoder gives the rotor angle</source>
        <translation>Nenhum encoder dá o ângulo do rotor</translation>
    </message>
    <message>
        <source>Not calibrated, or the encoder is not connected</source>
        <translation>Não calibrado, ou o encoder não está ligado</translation>
    </message>
    <message>
        <source>Calibrate the motor or reconnect the encoder</source>
        <translation>Calibre o motor ou ligue o encoder</translation>
    </message>
    <message>
        <source>No encoder gives the output position</source>
        <translation>Nenhum encoder dá a posição de saída</translation>
    </message>
    <message>
        <source>The gate driver of the motor outputs could not be switched on</source>
        <translation>Não foi possível ligar o gate driver das saídas do motor</translation>
    </message>
    <message>
        <source>The supply voltage is too low, or the board is damaged</source>
        <translation>A tensão de alimentação é baixa demais, ou a placa está danificada</translation>
    </message>
    <message>
        <source>The deprecated stop position was commanded together with motion limits</source>
        <translation>Foi comandada a obsoleta stop position juntamente com limites de movimento</translation>
    </message>
    <message>
        <source>Another program commands the drive</source>
        <translation>Outro programa comanda o acionamento</translation>
    </message>
    <message>
        <source>Back-EMF feedforward is on but no acceleration limit was in force</source>
        <translation>A compensação de força contraeletromotriz está ativa sem limite de aceleração em vigor</translation>
    </message>
    <message>
        <source>servo.default_accel_limit is not set, or another program commands the drive</source>
        <translation>servo.default_accel_limit não está definido, ou outro programa comanda o acionamento</translation>
    </message>
    <message>
        <source>Set servo.default_accel_limit on the Protection page, close other programs, then re-arm</source>
        <translation>Defina servo.default_accel_limit na página Proteções, feche outros programas e depois rearme</translation>
    </message>
    <message>
        <source>servopos.position_min/max lie beyond ±32768 turns</source>
        <translation>servopos.position_min/max ficam além de ±32768 voltas</translation>
    </message>
    <message>
        <source>Correct the bounds on the Protection page</source>
        <translation>Corrija os limites na página Proteções</translation>
    </message>
    <message>
        <source>The axis fell too far behind its set-point</source>
        <translation>O eixo ficou muito atrás da sua referência</translation>
    </message>
    <message>
        <source>The axis turned at a speed too far from its set-point</source>
        <translation>O eixo girou a uma velocidade muito diferente da sua referência</translation>
    </message>
    <message>
        <source>Limited by servo.max_velocity</source>
        <translation>Limitado por servo.max_velocity</translation>
    </message>
    <message>
        <source>A command faster than the drive allows</source>
        <translation>Um comando mais rápido do que o acionamento permite</translation>
    </message>
    <message>
        <source>Limited by servo.max_power_W</source>
        <translation>Limitado por servo.max_power_W</translation>
    </message>
    <message>
        <source>Speed and torque are both high</source>
        <translation>Velocidade e torque são ambos altos</translation>
    </message>
    <message>
        <source>Limited by the voltage of the supply</source>
        <translation>Limitado pela tensão da alimentação</translation>
    </message>
    <message>
        <source>The motor would need more voltage for its speed</source>
        <translation>O motor precisaria de mais tensão para a sua velocidade</translation>
    </message>
    <message>
        <source>Limited by servo.max_current_A</source>
        <translation>Limitado por servo.max_current_A</translation>
    </message>
    <message>
        <source>Wind, friction, a blocked axis or a high acceleration</source>
        <translation>Vento, atrito, eixo bloqueado ou aceleração alta</translation>
    </message>
    <message>
        <source>Current reduced because the board is warm</source>
        <translation>Corrente reduzida porque a placa está quente</translation>
    </message>
    <message>
        <source>Much torque for a long time, or too little cooling</source>
        <translation>Muito torque durante muito tempo, ou pouca refrigeração</translation>
    </message>
    <message>
        <source>Current reduced because the motor is warm</source>
        <translation>Corrente reduzida porque o motor está quente</translation>
    </message>
    <message>
        <source>Limited by the maximum torque of the command</source>
        <translation>Limitado pelo torque máximo do comando</translation>
    </message>
    <message>
        <source>The drive reports a code that register map 5 does not define</source>
        <translation>O acionamento relata um código que o mapa de registos 5 não define</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>parado</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>falha</translation>
    </message>
    <message>
        <source>enabling</source>
        <translation>a ativar</translation>
    </message>
    <message>
        <source>calibrating current sense</source>
        <translation>a calibrar a medição de corrente</translation>
    </message>
    <message>
        <source>calibration complete</source>
        <translation>calibração concluída</translation>
    </message>
    <message>
        <source>PWM</source>
        <translation>PWM</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>tensão</translation>
    </message>
    <message>
        <source>voltage FOC</source>
        <translation>tensão FOC</translation>
    </message>
    <message>
        <source>voltage DQ</source>
        <translation>tensão DQ</translation>
    </message>
    <message>
        <source>current</source>
        <translation>corrente</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posição</translation>
    </message>
    <message>
        <source>watchdog expired</source>
        <translation>watchdog esgotado</translation>
    </message>
    <message>
        <source>zero velocity</source>
        <translation>velocidade zero</translation>
    </message>
    <message>
        <source>stay within</source>
        <translation>permanecer dentro</translation>
    </message>
    <message>
        <source>measuring inductance</source>
        <translation>a medir a indutância</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>freio</translation>
    </message>
    <message>
        <source>undefined mode</source>
        <translation>modo indefinido</translation>
    </message>
    <message>
        <source>azimuth %1 below limit %2</source>
        <translation>azimute %1 abaixo do limite %2</translation>
    </message>
    <message>
        <source>azimuth %1 above limit %2</source>
        <translation>azimute %1 acima do limite %2</translation>
    </message>
    <message>
        <source>elevation %1 below limit %2</source>
        <translation>elevação %1 abaixo do limite %2</translation>
    </message>
    <message>
        <source>elevation %1 above limit %2</source>
        <translation>elevação %1 acima do limite %2</translation>
    </message>
    <message>
        <source>elevation %1 outside limits %2…%3</source>
        <translation>elevação %1 fora dos limites %2…%3</translation>
    </message>
    <message>
        <source>the elevation limit %1</source>
        <translation>limite de elevação %1</translation>
    </message>
    <message>
        <source>the keep-out &quot;%1&quot;</source>
        <translation>zona proibida &quot;%1&quot;</translation>
    </message>
    <message>
        <source>the horizon</source>
        <translation>horizonte</translation>
    </message>
    <message>
        <source>1 or -1 is expected</source>
        <translation>espera-se 1 ou -1</translation>
    </message>
    <message>
        <source>%1 is not below %2.travel_max_deg (%3)</source>
        <translation>%1 não é menor que %2.travel_max_deg (%3)</translation>
    </message>
    <message>
        <source>%1 is outside the travel %2…%3</source>
        <translation>%1 está fora do curso %2…%3</translation>
    </message>
    <message>
        <source>must be at least max_acceleration_deg_s2 per second, here %1</source>
        <translation>tem de ser pelo menos max_acceleration_deg_s2 por segundo, aqui %1</translation>
    </message>
    <message>
        <source>must not be above %1</source>
        <translation>não pode ser maior que %1</translation>
    </message>
    <message>
        <source>is shorter than 2 ticks of control.tick_hz (%1 s)</source>
        <translation>é menor que 2 ciclos de control.tick_hz (%1 s)</translation>
    </message>
    <message>
        <source>must be below %1</source>
        <translation>tem de ser menor que %1</translation>
    </message>
    <message>
        <source>is shorter than 3 ticks of control.tick_hz (%1 s)</source>
        <translation>é menor que 3 ciclos de control.tick_hz (%1 s)</translation>
    </message>
    <message>
        <source>must lie between jog.slow_deg_s and jog.fast_deg_s</source>
        <translation>tem de ficar entre jog.slow_deg_s e jog.fast_deg_s</translation>
    </message>
    <message>
        <source>is needed while rotctld.lead is &quot;locked&quot;</source>
        <translation>é necessário enquanto rotctld.lead é &quot;locked&quot;</translation>
    </message>
    <message>
        <source>HOST:PORT with a port of 0…65535 is expected</source>
        <translation>Espera-se HOST:PORTA com uma porta de 0…65535</translation>
    </message>
    <message>
        <source>a host name or address is expected before the port, IPv6 in brackets</source>
        <translation>espera-se um nome ou endereço antes da porta, IPv6 entre colchetes</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>falta %1</translation>
    </message>
    <message>
        <source>azimuths count from north, 0…360</source>
        <translation>os azimutes contam-se a partir do norte, 0…360</translation>
    </message>
    <message>
        <source>an elevation is within -90…90</source>
        <translation>uma elevação fica entre -90…90</translation>
    </message>
    <message>
        <source>azimuth and elevation are expected, like &quot;120.5 7&quot;, not &quot;%1&quot;</source>
        <translation>esperam-se azimute e elevação, como &quot;120.5 7&quot;, e não &quot;%1&quot;</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… e mais %1</translation>
    </message>
    <message>
        <source>a locator has 4, 6, 8 or 10 characters, like JN58td</source>
        <translation>um localizador tem 4, 6, 8 ou 10 caracteres, como JN58td</translation>
    </message>
    <message>
        <source>character %1 of a locator is one of %2…%3</source>
        <translation>o caractere %1 de um localizador é um de %2…%3</translation>
    </message>
    <message>
        <source>latitude -90…90° and longitude -180…180° are expected</source>
        <translation>esperam-se latitude -90…90° e longitude -180…180°</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 ponto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 pontos</translation>
    </message>
    <message>
        <source>%1, %2 different</source>
        <translation>%1, %2 diferentes</translation>
    </message>
    <message>
        <source>(different)</source>
        <translation>(diferente)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>&quot;version = 1&quot; is expected</source>
        <translation>espera-se &quot;version = 1&quot;</translation>
    </message>
    <message>
        <source>%1 is not known to this program, which reads version %2</source>
        <translation>%1 não é conhecida deste programa, que lê a versão %2</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>chave desconhecida</translation>
    </message>
    <message>
        <source>unknown table</source>
        <translation>tabela desconhecida</translation>
    </message>
    <message>
        <source>&quot;[[%1]]&quot; is expected</source>
        <translation>espera-se &quot;[[%1]]&quot;</translation>
    </message>
    <message>
        <source>a table is expected</source>
        <translation>espera-se uma tabela</translation>
    </message>
    <message>
        <source>a list of points is expected, like [[0.0, 5.0], [180.0, 2.5]]</source>
        <translation>espera-se uma lista de pontos, como [[0.0, 5.0], [180.0, 2.5]]</translation>
    </message>
    <message>
        <source>a point is [azimuth, elevation]</source>
        <translation>um ponto é [azimute, elevação]</translation>
    </message>
    <message>
        <source>a number or a text in quotes is expected</source>
        <translation>espera-se um número ou um texto entre aspas</translation>
    </message>
    <message>
        <source>%1: cannot be renamed to %2</source>
        <translation>não é possível mudar o nome de %1 para %2</translation>
    </message>
    <message>
        <source>%1: there is no such profile</source>
        <translation>%1: não existe esse perfil</translation>
    </message>
    <message>
        <source>%1 is not below limits.%2_max_deg (%3)</source>
        <translation>%1 não é menor que limits.%2_max_deg (%3)</translation>
    </message>
    <message>
        <source>%1 is outside the limits of operation %2…%3</source>
        <translation>%1 está fora dos limites de operação %2…%3</translation>
    </message>
    <message>
        <source>%1 is not below elevation_max_deg (%2)</source>
        <translation>%1 não é menor que elevation_max_deg (%2)</translation>
    </message>
    <message>
        <source>Azimuth of the point, from true north.</source>
        <translation>Azimute do ponto, a partir do norte verdadeiro.</translation>
    </message>
    <message>
        <source>Azimuth, from true north.</source>
        <translation>Azimute, a partir do norte verdadeiro.</translation>
    </message>
    <message>
        <source>motor turns = sign × (angle + offset) / 360 × gear ratio.</source>
        <translation>voltas do motor = sinal × (ângulo + desvio) / 360 × redução.</translation>
    </message>
    <message>
        <source>What the drive does by itself when its watchdog expires: &quot;hold&quot; (servo.timeout_mode 10) or &quot;brake&quot; (15, for self-locking gearboxes only).</source>
        <translation>O que o acionamento faz por si quando o seu watchdog se esgota: &quot;hold&quot; (servo.timeout_mode 10) ou &quot;brake&quot; (15, só para redutores autoblocantes).</translation>
    </message>
    <message>
        <source>The drives stop by themselves after this time without a command.</source>
        <translation>Os acionamentos param por si após este tempo sem comando.</translation>
    </message>
    <message>
        <source>a finite number is expected</source>
        <translation>espera-se um número finito</translation>
    </message>
    <message>
        <source>%1 is outside %2…%3</source>
        <translation>%1 está fora de %2…%3</translation>
    </message>
    <message>
        <source>one line of 1 to 60 bytes is expected</source>
        <translation>espera-se uma linha de 1 a 60 bytes</translation>
    </message>
    <message>
        <source>a number is expected</source>
        <translation>espera-se um número</translation>
    </message>
    <message>
        <source>a whole number is expected</source>
        <translation>espera-se um número inteiro</translation>
    </message>
    <message>
        <source>a text in quotes is expected</source>
        <translation>espera-se um texto entre aspas</translation>
    </message>
    <message>
        <source>a list of texts in quotes is expected, like [&quot;one&quot;, &quot;two&quot;]</source>
        <translation>espera-se uma lista de textos entre aspas, como [&quot;um&quot;, &quot;dois&quot;]</translation>
    </message>
    <message>
        <source>How long a following error may last.</source>
        <translation>Quanto tempo pode durar um erro de seguimento.</translation>
    </message>
    <message>
        <source>an argument is longer than %1 characters</source>
        <translation>um argumento tem mais de %1 caracteres</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not understood</source>
        <translation>não se compreende %1 &quot;%2&quot;</translation>
    </message>
    <message>
        <source>elevation %1° is outside -90°…180°</source>
        <translation>a elevação %1° está fora de -90°…180°</translation>
    </message>
    <message>
        <source>cannot watch sockets: %1</source>
        <translation>não é possível vigiar os sockets: %1</translation>
    </message>
    <message>
        <source>the server was closed</source>
        <translation>o servidor foi encerrado</translation>
    </message>
    <message>
        <source>refused: %1 clients are connected</source>
        <translation>recusado: %1 clientes estão conectados</translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation>perdido: %1</translation>
    </message>
    <message>
        <source>dropped: %1</source>
        <translation>desconectado: %1</translation>
    </message>
    <message>
        <source>lost: its answers cannot be sent</source>
        <translation>perdido: não é possível enviar-lhe as respostas</translation>
    </message>
    <message>
        <source>dropped: does not read its answers</source>
        <translation>desconectado: não lê as suas respostas</translation>
    </message>
    <message>
        <source>dropped: floods without waiting for answers</source>
        <translation>desconectado: inunda sem esperar respostas</translation>
    </message>
    <message>
        <source>dropped: left a command unfinished</source>
        <translation>desconectado: deixou um comando por acabar</translation>
    </message>
    <message>
        <source>sent %1 bytes without a line end</source>
        <translation>enviou %1 bytes sem fim de linha</translation>
    </message>
    <message>
        <source>closed the connection</source>
        <translation>fechou a ligação</translation>
    </message>
    <message>
        <source>&quot;%1&quot; refused: %2</source>
        <translation>&quot;%1&quot; recusado: %2</translation>
    </message>
    <message>
        <source>unknown command &quot;%1&quot;</source>
        <translation>comando &quot;%1&quot; desconhecido</translation>
    </message>
    <message>
        <source>sent %1 unknown commands in a row</source>
        <translation>enviou %1 comandos desconhecidos seguidos</translation>
    </message>
    <message>
        <source>there is no level &quot;%1&quot;</source>
        <translation>não existe o nível &quot;%1&quot;</translation>
    </message>
    <message>
        <source>wanted to change %1: refused</source>
        <translation>quis alterar %1: recusado</translation>
    </message>
    <message>
        <source>limits are set in the profile, not by clients</source>
        <translation>os limites definem-se no perfil, não pelos clientes</translation>
    </message>
    <message>
        <source>there is no function &quot;%1&quot;</source>
        <translation>não existe a função &quot;%1&quot;</translation>
    </message>
    <message>
        <source>cannot listen on %1: not an IP address</source>
        <translation>não é possível escutar em %1: não é um endereço IP</translation>
    </message>
    <message>
        <source>cannot listen on %1: %2</source>
        <translation>não é possível escutar em %1: %2</translation>
    </message>
    <message>
        <source>no reply from the %1</source>
        <translation>sem resposta do %1</translation>
    </message>
    <message>
        <source>Boresight is closing</source>
        <translation>O Boresight está a encerrar</translation>
    </message>
    <message>
        <source>STOP is not latched</source>
        <translation>STOP não está ativo</translation>
    </message>
    <message>
        <source>a drive has stopped answering</source>
        <translation>um acionamento deixou de responder</translation>
    </message>
    <message>
        <source>there is no fault to re-arm from</source>
        <translation>não há falha de que rearmar</translation>
    </message>
    <message>
        <source>every drive must answer before re-arming</source>
        <translation>todos os acionamentos têm de responder antes de rearmar</translation>
    </message>
    <message>
        <source>a moment ago</source>
        <translation>há um momento</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>há %1 s</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>azimute</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>elevação</translation>
    </message>
    <message>
        <source>the axis did not reach the speed</source>
        <translation>o eixo não atingiu a velocidade</translation>
    </message>
    <message>
        <source>its drive did not come back</source>
        <translation>o seu acionamento não voltou</translation>
    </message>
    <message>
        <source>moving the %1 up to speed</source>
        <translation>a levar o eixo de %1 à velocidade</translation>
    </message>
    <message>
        <source>holding the %1 again</source>
        <translation>a manter de novo o eixo de %1</translation>
    </message>
    <message>
        <source>The %1 switched itself off</source>
        <translation>O %1 desligou-se</translation>
    </message>
    <message>
        <source>written: %1</source>
        <translation>escrito: %1</translation>
    </message>
    <message>
        <source>changed meanwhile: %1</source>
        <translation>alterado entretanto: %1</translation>
    </message>
    <message>
        <source>azimuth drive</source>
        <translation>acionamento de azimute</translation>
    </message>
    <message>
        <source>elevation drive</source>
        <translation>acionamento de elevação</translation>
    </message>
    <message>
        <source>cannot write %1: %2</source>
        <translation>não é possível escrever %1: %2</translation>
    </message>
    <message>
        <source>%1 similar lines left out</source>
        <translation>%1 linhas semelhantes omitidas</translation>
    </message>
    <message>
        <source>listening on %1</source>
        <translation>escuta em %1</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>recusado: %1</translation>
    </message>
    <message>
        <source>disconnected by the operator</source>
        <translation>desconectado pelo operador</translation>
    </message>
    <message>
        <source>changes %1 from %2 to %3</source>
        <translation>altera %1 de %2 para %3</translation>
    </message>
    <message>
        <source>changes %1 from %2 to %3, in force after Reconnect</source>
        <translation>altera %1 de %2 para %3, em vigor após Reconectar</translation>
    </message>
    <message>
        <source>Check the disk, or choose another folder with --state-dir</source>
        <translation>Verifique o disco, ou escolha outra pasta com --state-dir</translation>
    </message>
    <message>
        <source>gives control back to the clients</source>
        <translation>devolve o controlo aos clientes</translation>
    </message>
    <message>
        <source>gives control to %1</source>
        <translation>dá o controlo a %1</translation>
    </message>
    <message>
        <source>lets %1 only read and stop</source>
        <translation>deixa %1 apenas ler e parar</translation>
    </message>
    <message>
        <source>lets %1 move the mount again</source>
        <translation>deixa %1 mover de novo a montagem</translation>
    </message>
    <message>
        <source>moves the mount from %1: %2</source>
        <translation>move a montagem a partir de %1: %2</translation>
    </message>
    <message>
        <source>ended before it was done</source>
        <translation>terminado antes de concluído</translation>
    </message>
    <message>
        <source>go to %1</source>
        <translation>ir a %1</translation>
    </message>
    <message>
        <source>go to axes %1</source>
        <translation>ir aos eixos %1</translation>
    </message>
    <message>
        <source>step to %1</source>
        <translation>passo até %1</translation>
    </message>
    <message>
        <source>park at %1</source>
        <translation>estacionar em %1</translation>
    </message>
    <message>
        <source>home to %1</source>
        <translation>origem em %1</translation>
    </message>
    <message>
        <source>horizon at %1</source>
        <translation>horizonte em %1</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>manual</translation>
    </message>
    <message>
        <source>move</source>
        <translation>mover</translation>
    </message>
    <message>
        <source>no fresh position from the %1</source>
        <translation>sem posição recente do %1</translation>
    </message>
    <message>
        <source>ends the motion: %1</source>
        <translation>termina o movimento: %1</translation>
    </message>
    <message>
        <source>at the end of the travel</source>
        <translation>no fim de curso</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>em: %1</translation>
    </message>
    <message>
        <source>holds by itself</source>
        <translation>mantém-se por si próprio</translation>
    </message>
    <message>
        <source>in its own time-out mode</source>
        <translation>no seu próprio modo de tempo esgotado</translation>
    </message>
    <message>
        <source>%1 accepted</source>
        <translation>%1 aceito</translation>
    </message>
    <message>
        <source>%1 refused: %2</source>
        <translation>%1 recusado: %2</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>conectado</translation>
    </message>
    <message>
        <source>every drive must answer</source>
        <translation>todos os acionamentos têm de responder</translation>
    </message>
    <message>
        <source>ended by the %1</source>
        <translation>terminado por: %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>concluído</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>linha de comando</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>operador</translation>
    </message>
    <message>
        <source>station</source>
        <translation>estação</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>acionamentos</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>barramento</translation>
    </message>
    <message>
        <source>log</source>
        <translation>registo</translation>
    </message>
    <message>
        <source>DISCONNECTED</source>
        <comment>station state</comment>
        <translation>SEM LIGAÇÃO</translation>
    </message>
    <message>
        <source>STANDBY</source>
        <comment>station state</comment>
        <translation>EM ESPERA</translation>
    </message>
    <message>
        <source>HOLD</source>
        <comment>station state</comment>
        <translation>MANTIDO</translation>
    </message>
    <message>
        <source>SLEW</source>
        <comment>station state</comment>
        <translation>A CAMINHO</translation>
    </message>
    <message>
        <source>TRACK</source>
        <comment>station state</comment>
        <translation>RASTREIO</translation>
    </message>
    <message>
        <source>JOG</source>
        <comment>station state</comment>
        <translation>MANUAL</translation>
    </message>
    <message>
        <source>PARKED</source>
        <comment>station state</comment>
        <translation>ESTACIONADO</translation>
    </message>
    <message>
        <source>CALIBRATE</source>
        <comment>station state</comment>
        <translation>CALIBRAÇÃO</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <comment>station state</comment>
        <translation>PARADO</translation>
    </message>
    <message>
        <source>FAULT</source>
        <comment>station state</comment>
        <translation>FALHA</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <comment>axis state</comment>
        <translation>SEM DADOS</translation>
    </message>
    <message>
        <source>HOLDING</source>
        <comment>axis state</comment>
        <translation>MANTIDO</translation>
    </message>
    <message>
        <source>MOVING</source>
        <comment>axis state</comment>
        <translation>MOVE-SE</translation>
    </message>
    <message>
        <source>LIMIT</source>
        <comment>axis state</comment>
        <translation>LIMITE</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <comment>axis state</comment>
        <translation>PARADO</translation>
    </message>
    <message>
        <source>FAULT</source>
        <comment>axis state</comment>
        <translation>FALHA</translation>
    </message>
    <message>
        <source>ON</source>
        <comment>axis state</comment>
        <translation>LIGADO</translation>
    </message>
    <message>
        <source>OFF</source>
        <comment>axis state</comment>
        <translation>DESLIGADO</translation>
    </message>
    <message>
        <source>held at %1</source>
        <translation>retido em: %1</translation>
    </message>
    <message>
        <source>held: %1</source>
        <translation>retido: %1</translation>
    </message>
    <message>
        <source>the azimuth</source>
        <translation>eixo de azimute</translation>
    </message>
    <message>
        <source>the elevation</source>
        <translation>eixo de elevação</translation>
    </message>
    <message>
        <source>%1 is at %2, %3 beyond its travel %4…%5, and moves farther out</source>
        <translation>o %1 está em %2, %3 além do seu curso %4…%5, e afasta-se mais</translation>
    </message>
    <message>
        <source>%1 is at %2, %3 beyond its travel %4…%5</source>
        <translation>o %1 está em %2, %3 além do seu curso %4…%5</translation>
    </message>
    <message>
        <source>%1 needs %2 Nm, %3 % of the %4 Nm allowed</source>
        <translation>o %1 precisa de %2 Nm, %3 % dos %4 Nm permitidos</translation>
    </message>
    <message>
        <source>the supply of %1</source>
        <translation>a alimentação do %1</translation>
    </message>
    <message>
        <source>the drive board of %1</source>
        <translation>a placa do acionamento do %1</translation>
    </message>
    <message>
        <source>the motor of %1</source>
        <translation>o motor do %1</translation>
    </message>
    <message>
        <source>Look for wind, a person at the antenna or a slipping gear. Secure the axis, then check the position.</source>
        <translation>Procure vento, uma pessoa junto à antena ou uma engrenagem que patina. Segure o eixo e depois verifique a posição.</translation>
    </message>
    <message>
        <source>Jog the axis back inside while you watch the cable.</source>
        <translation>Traga o eixo de volta com movimento manual enquanto observa o cabo.</translation>
    </message>
    <message>
        <source>Check the load of the bus and of this computer, the cable and the termination.</source>
        <translation>Verifique a carga do barramento e deste computador, o cabo e a terminação.</translation>
    </message>
    <message>
        <source>Look for wind, ice, friction or a load out of balance.</source>
        <translation>Procure vento, gelo, atrito ou uma carga desequilibrada.</translation>
    </message>
    <message>
        <source>writing the settings of %1 was interrupted: some are in force but not stored</source>
        <translation>a escrita dos parâmetros do acionamento de %1 foi interrompida: alguns estão em vigor mas não guardados</translation>
    </message>
    <message>
        <source>it does not answer</source>
        <translation>não responde</translation>
    </message>
    <message>
        <source>%1 did not store its settings: %2</source>
        <translation>o acionamento de %1 não guardou os seus parâmetros: %2</translation>
    </message>
    <message>
        <source>%1: %2 was %3, is %4</source>
        <translation>%1: %2 era %3, é %4</translation>
    </message>
    <message>
        <source>the board</source>
        <translation>a placa</translation>
    </message>
    <message>
        <source>asking %1</source>
        <translation>a consultar o acionamento de %1</translation>
    </message>
    <message>
        <source>storing %1 of %2</source>
        <translation>a guardar %1 do acionamento de %2</translation>
    </message>
    <message>
        <source>writing %1 of %2</source>
        <translation>a escrever %1 do acionamento de %2</translation>
    </message>
    <message>
        <source>reading %1 of %2</source>
        <translation>lendo %1 do acionamento de %2</translation>
    </message>
    <message>
        <source>the settings</source>
        <translation>os parâmetros</translation>
    </message>
    <message>
        <source>a setting of the %1 drive is worth fixing: %2</source>
        <translation>um parâmetro do acionamento de %1 merece correção: %2</translation>
    </message>
    <message>
        <source>the drives are not read yet</source>
        <translation>os acionamentos ainda não foram lidos</translation>
    </message>
    <message>
        <source>Press Fix again.</source>
        <translation>Clique de novo em Corrigir.</translation>
    </message>
    <message>
        <source>looking for the drives</source>
        <translation>à procura dos acionamentos</translation>
    </message>
    <message>
        <source>the settings were written, read back and stored</source>
        <translation>os parâmetros foram escritos, lidos de volta e guardados</translation>
    </message>
    <message>
        <source>UUID unread</source>
        <translation>UUID não lido</translation>
    </message>
    <message>
        <source>Install firmware with the register map %1 in the board (moteus_tool --flash), or a newer Boresight.</source>
        <translation>Instale na placa firmware com o mapa de registos %1 (moteus_tool --flash), ou um Boresight mais novo.</translation>
    </message>
    <message>
        <source>no drive answers on the bus</source>
        <translation>nenhum acionamento responde no barramento</translation>
    </message>
    <message>
        <source>%1 to %2 %3 (%4)</source>
        <translation>%1 a %2 %3 (%4)</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>voltas</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desligado</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>manter</translation>
    </message>
    <message>
        <source>damp</source>
        <translation>amortecer</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconhecido</translation>
    </message>
    <message>
        <source>0.05 to 0.2 s</source>
        <translation>0.05 a 0.2 s</translation>
    </message>
    <message>
        <source>above 0 Nm</source>
        <translation>acima de 0 Nm</translation>
    </message>
    <message>
        <source>above 0 A</source>
        <translation>acima de 0 A</translation>
    </message>
    <message>
        <source>10 to 46 V</source>
        <translation>10 a 46 V</translation>
    </message>
    <message>
        <source>1 to 20 V</source>
        <translation>1 a 20 V</translation>
    </message>
    <message>
        <source>turns/s</source>
        <translation>voltas/s</translation>
    </message>
    <message>
        <source>turns/s²</source>
        <translation>voltas/s²</translation>
    </message>
    <message>
        <source>1 or -1</source>
        <translation>1 ou -1</translation>
    </message>
    <message>
        <source>0 or above</source>
        <translation>0 ou acima</translation>
    </message>
    <message>
        <source>any</source>
        <translation>qualquer</translation>
    </message>
    <message>
        <source>none or ≥ 1°</source>
        <translation>nenhum ou ≥ 1°</translation>
    </message>
    <message>
        <source>not known to this firmware</source>
        <translation>desconhecido deste firmware</translation>
    </message>
    <message>
        <source>The journal file %1 is missing</source>
        <translation>Falta o ficheiro do diário %1</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 não é finito</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 não é um número</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 está fora da faixa</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 não é um número inteiro</translation>
    </message>
    <message>
        <source>%1 is neither true nor false</source>
        <translation>%1 não é nem true nem false</translation>
    </message>
    <message>
        <source>%1 is not of the form 8-4-4-4-12 digits</source>
        <translation>%1 não tem a forma de 8-4-4-4-12 algarismos</translation>
    </message>
    <message>
        <source>%1 is not a UTC time from 1970 to 2200</source>
        <translation>%1 não é uma hora UTC de 1970 a 2200</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>está vazio</translation>
    </message>
    <message>
        <source>The drive was restarted %1 ago</source>
        <translation>O acionamento foi reiniciado há %1</translation>
    </message>
    <message>
        <source>The journal is of another drive (%1)</source>
        <translation>O diário é de outro acionamento (%1)</translation>
    </message>
    <message>
        <source>The profile trusts the drive&apos;s position</source>
        <translation>O perfil confia na posição do acionamento</translation>
    </message>
    <message>
        <source>The drive kept its power since the journal was written</source>
        <translation>O acionamento manteve a alimentação desde que o diário foi escrito</translation>
    </message>
    <message>
        <source>There is no sensor to compare with</source>
        <translation>Não há sensor com que comparar</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 dias</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>escolhido</translation>
    </message>
    <message>
        <source>%1 stands at %2: %3</source>
        <translation>%1 está em %2: %3</translation>
    </message>
    <message>
        <source>USB serial port</source>
        <translation>Porta serial USB</translation>
    </message>
    <message>
        <source>CAN interface</source>
        <translation>Interface CAN</translation>
    </message>
    <message>
        <source>%1, down</source>
        <translation>%1, desativada</translation>
    </message>
    <message>
        <source>Simulated mount</source>
        <translation>Montagem simulada</translation>
    </message>
    <message>
        <source>The drive&apos;s position was set by another tool</source>
        <translation>A posição do acionamento foi definida por outra ferramenta</translation>
    </message>
    <message>
        <source>%1: no permission. Join the group dialout with `sudo usermod -aG dialout $USER`, then log in again</source>
        <translation>%1: sem permissão. Entre no grupo dialout com `sudo usermod -aG dialout $USER`, depois inicie a sessão de novo</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>não se pode ler %1: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>linha %1: %2</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>a path on one line is expected</source>
        <translation>espera-se um caminho numa só linha</translation>
    </message>
    <message>
        <source>a topic is expected, like &quot;antenna/orientation&quot;, without + and #</source>
        <translation>espera-se um tópico, como &quot;antenna/orientation&quot;, sem + nem #</translation>
    </message>
    <message>
        <source>MQTT topic of the sensor&apos;s own calibration.</source>
        <translation>Tópico MQTT da calibração própria do sensor.</translation>
    </message>
    <message>
        <source>How long the firmware averages the azimuth.</source>
        <translation>Durante quanto tempo o firmware faz a média do azimute.</translation>
    </message>
    <message>
        <source>How long sensor and axes may differ.</source>
        <translation>Durante quanto tempo sensor e eixos podem diferir.</translation>
    </message>
    <message>
        <source>is needed while sensor.source is &quot;serial&quot;</source>
        <translation>é necessário enquanto sensor.source for &quot;serial&quot;</translation>
    </message>
    <message>
        <source>&quot;simulated&quot; needs the simulated mount (bus.name)</source>
        <translation>&quot;simulated&quot; exige a montagem simulada (bus.name)</translation>
    </message>
    <message>
        <source>is the same as another topic of the sensor</source>
        <translation>é igual a outro tópico do sensor</translation>
    </message>
    <message>
        <source>needs the place of the mount (site)</source>
        <translation>precisa do local da montagem (site)</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>sem motivo indicado</translation>
    </message>
    <message>
        <source>MQTT broker %1: %2</source>
        <translation>Broker MQTT %1: %2</translation>
    </message>
    <message>
        <source>closed by the broker</source>
        <translation>fechada pelo broker</translation>
    </message>
    <message>
        <source>one line of at most 200 bytes is expected</source>
        <translation>espera-se uma linha de no máximo 200 bytes</translation>
    </message>
    <message>
        <source>the beginning of a topic is expected, like &quot;boresight/&quot;, without + # and $</source>
        <translation>espera-se o começo de um tópico, como &quot;boresight/&quot;, sem + # e $</translation>
    </message>
    <message>
        <source>is needed with a password</source>
        <translation>é preciso junto com uma palavra-passe</translation>
    </message>
    <message>
        <source>(hidden)</source>
        <translation>(oculta)</translation>
    </message>
    <message>
        <source>connected to the broker %1</source>
        <translation>conectado ao broker %1</translation>
    </message>
    <message>
        <source>across: %1</source>
        <translation>de través: %1</translation>
    </message>
    <message>
        <source>in elevation: %1</source>
        <translation>em elevação: %1</translation>
    </message>
    <message>
        <source>%1 is not within %2…%3</source>
        <translation>%1 não está em %2…%3</translation>
    </message>
    <message>
        <source>a text in quotes is expected, without control characters</source>
        <translation>espera-se um texto entre aspas, sem caracteres de controlo</translation>
    </message>
    <message>
        <source>true or false is expected</source>
        <translation>espera-se true ou false</translation>
    </message>
    <message>
        <source>a UTC time is expected, like 2026-11-21T21:34:00.000Z</source>
        <translation>espera-se uma hora UTC, como 2026-11-21T21:34:00.000Z</translation>
    </message>
    <message>
        <source>&quot;%1&quot; or &quot;%2&quot; is expected</source>
        <translation>espera-se &quot;%1&quot; ou &quot;%2&quot;</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>its compass is not calibrated (magnetometer %1, system %2 of 3)</source>
        <translation>a sua bússola não está calibrada (magnetómetro %1, sistema %2 de 3)</translation>
    </message>
    <message>
        <source>The orientation sensor and the axes differ by %1 in azimuth</source>
        <translation>O sensor de orientação e os eixos diferem %1 em azimute</translation>
    </message>
    <message>
        <source>The orientation sensor and the axes differ by %1 in elevation</source>
        <translation>O sensor de orientação e os eixos diferem %1 em elevação</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>sensor</translation>
    </message>
    <message>
        <source>(mechanical angles)</source>
        <translation>(ângulos mecânicos)</translation>
    </message>
    <message>
        <source>How much lower the beam hangs at the horizon than at the zenith.</source>
        <translation>Quanto o feixe pende mais baixo no horizonte do que no zénite.</translation>
    </message>
    <message>
        <source>a path from / on is expected</source>
        <translation>espera-se um caminho desde /</translation>
    </message>
    <message>
        <source>the target is beyond %1</source>
        <translation>o alvo está além de %1</translation>
    </message>
    <message>
        <source>STOP is not confirmed</source>
        <translation>STOP não está confirmado</translation>
    </message>
    <message>
        <source>Use the hard-wired emergency stop if the mount moves</source>
        <translation>Use a paragem de emergência por cabo se a montagem se mover</translation>
    </message>
    <message>
        <source>The beam is less than %1° from the Sun</source>
        <translation>O feixe está a menos de %1° do Sol</translation>
    </message>
    <message>
        <source>The beam may be less than %1° from the Sun, because the mount has only one axis</source>
        <translation>O feixe pode estar a menos de %1° do Sol, porque a montagem só tem um eixo</translation>
    </message>
    <message>
        <source>landmark</source>
        <translation>ponto de referência</translation>
    </message>
    <message>
        <source>swings the compass: %1</source>
        <translation>gira a bússola: %1</translation>
    </message>
    <message>
        <source>ended by the operator</source>
        <translation>terminado pelo operador</translation>
    </message>
    <message>
        <source>applies &quot;%1&quot;: %2</source>
        <translation>aplica &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>applies &quot;%1&quot; again</source>
        <translation>aplica &quot;%1&quot; de novo</translation>
    </message>
    <message>
        <source>azimuth offset</source>
        <translation>desvio de azimute</translation>
    </message>
    <message>
        <source>elevation offset</source>
        <translation>desvio de elevação</translation>
    </message>
    <message>
        <source>tilt north</source>
        <translation>inclinação para norte</translation>
    </message>
    <message>
        <source>tilt east</source>
        <translation>inclinação para leste</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>colimação</translation>
    </message>
    <message>
        <source>non-perpendicularity</source>
        <translation>não perpendicularidade</translation>
    </message>
    <message>
        <source>elevation sag</source>
        <translation>flexão em elevação</translation>
    </message>
    <message>
        <source>North from the sensor</source>
        <translation>Norte pelo sensor</translation>
    </message>
    <message>
        <source>North from the compass swing</source>
        <translation>Norte pelo giro da bússola</translation>
    </message>
    <message>
        <source>Pointing model from %1 points</source>
        <translation>Modelo de apontamento de %1 pontos</translation>
    </message>
    <message>
        <source>nothing changes</source>
        <translation>nada muda</translation>
    </message>
    <message>
        <source>at another site</source>
        <translation>noutro local</translation>
    </message>
    <message>
        <source>with another drive</source>
        <translation>com outro acionamento</translation>
    </message>
    <message>
        <source>done, from %1 readings</source>
        <translation>feito, de %1 leituras</translation>
    </message>
    <message>
        <source>%1, peak</source>
        <translation>%1, pico</translation>
    </message>
    <message>
        <source>ends without a result: %1</source>
        <translation>termina sem resultado: %1</translation>
    </message>
    <message>
        <source>back to the middle</source>
        <translation>de volta ao meio</translation>
    </message>
    <message>
        <source>place %1 of %2</source>
        <translation>lugar %1 de %2</translation>
    </message>
    <message>
        <source>%1: waits for the power</source>
        <translation>%1: espera a potência</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Lua</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibração</translation>
    </message>
    <message>
        <source>azimuth axis from %1 to %2 and back, elevation stays at %3</source>
        <translation>eixo de azimute de %1 a %2 e de volta, a elevação fica em %3</translation>
    </message>
    <message>
        <source>at %1°/s</source>
        <translation>a %1°/s</translation>
    </message>
    <message>
        <source>with %1 stops each way</source>
        <translation>com %1 paradas em cada sentido</translation>
    </message>
    <message>
        <source>about %1 min %2 s</source>
        <translation>cerca de %1 min %2 s</translation>
    </message>
    <message>
        <source>turning clockwise</source>
        <translation>a girar no sentido horário</translation>
    </message>
    <message>
        <source>turning counter-clockwise</source>
        <translation>a girar no sentido anti-horário</translation>
    </message>
    <message>
        <source>a host name or address is expected, without port, brackets or ://</source>
        <translation>espera-se um nome ou endereço de computador, sem porta, colchetes ou ://</translation>
    </message>
    <message>
        <source>UDP or TCP port of the received power.</source>
        <translation>Porta UDP ou TCP da potência recebida.</translation>
    </message>
    <message>
        <source>an address of this computer is expected while power.source is &quot;udp&quot;</source>
        <translation>espera-se um endereço deste computador enquanto power.source é &quot;udp&quot;</translation>
    </message>
    <message>
        <source>still sensor</source>
        <translation>sensor parado</translation>
    </message>
    <message>
        <source>compass swing</source>
        <translation>giro da bússola</translation>
    </message>
    <message>
        <source>Pointing model from 1 point</source>
        <translation>Modelo de apontamento de 1 ponto</translation>
    </message>
    <message>
        <source>points</source>
        <translation>pontos</translation>
    </message>
    <message>
        <source>Typed terms</source>
        <translation>Termos digitados</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>digitado</translation>
    </message>
    <message>
        <source>Terms from %1</source>
        <translation>Termos de %1</translation>
    </message>
    <message>
        <source>The pointing model in force (&quot;%1&quot;, %2) was applied with another drive</source>
        <translation>O modelo de apontamento em vigor (&quot;%1&quot;, %2) foi aplicado com outro acionamento</translation>
    </message>
    <message>
        <source>The pointing model in force (&quot;%1&quot;, %2) was applied at another site</source>
        <translation>O modelo de apontamento em vigor (&quot;%1&quot;, %2) foi aplicado em outro local</translation>
    </message>
    <message>
        <source>arcs of headings from 0 to 360° are expected, like &quot;40-80, 350-20&quot;</source>
        <translation>esperam-se arcos de rumos de 0 a 360°, como &quot;40-80, 350-20&quot;</translation>
    </message>
    <message>
        <source>its unit is not dB</source>
        <translation>a sua unidade não é dB</translation>
    </message>
    <message>
        <source>readings: %1</source>
        <translation>leituras: %1</translation>
    </message>
    <message>
        <source>far off the curve</source>
        <translation>muito longe da curva</translation>
    </message>
    <message>
        <source>turning faster than %1°/s</source>
        <translation>a girar a mais de %1°/s</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 a %3</translation>
    </message>
    <message>
        <source>%1, left out: %2</source>
        <translation>%1, ficaram de fora: %2</translation>
    </message>
    <message>
        <source>Offset of the sensor</source>
        <translation>Desvio do sensor</translation>
    </message>
    <message>
        <source>Curve of the compass</source>
        <translation>Curva da bússola</translation>
    </message>
    <message>
        <source>mounting or curve of the sensor</source>
        <translation>montagem ou curva do sensor</translation>
    </message>
    <message>
        <source>%1, changed by hand since</source>
        <translation>%1, alterado à mão depois</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>de um ficheiro</translation>
    </message>
    <message>
        <source>discards &quot;%1&quot;</source>
        <translation>descarta &quot;%1&quot;</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>outro programa</translation>
    </message>
    <message>
        <source>%1 is another USB device (%2:%3 %4). Known adapters are 0483:5740 and 1209:2323. Nothing was sent to it. If it is an adapter, enter it as the bus of the profile</source>
        <translation>%1 é outro dispositivo USB (%2:%3 %4). Os adaptadores conhecidos são 0483:5740 e 1209:2323. Não lhe foi enviado nada. Se for um adaptador, indique-o como barramento no perfil</translation>
    </message>
    <message>
        <source>no fdcanusb answers on this port. Choose the right port. If this is the right one, plug the adapter in again, or press &quot;Release bus&quot; and &quot;Take bus back&quot; on the Drives page</source>
        <translation>nenhum fdcanusb responde nesta porta. Escolha a porta certa. Se a porta for esta, desconecte o adaptador e conecte-o de novo, ou clique em &quot;Liberar barramento&quot; e em &quot;Retomar barramento&quot; na página Acionamentos</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>não é um ficheiro comum</translation>
    </message>
    <message>
        <source>Sun at any time: the clock is not synchronised</source>
        <translation>Sol a qualquer hora: o relógio não está sincronizado</translation>
    </message>
    <message>
        <source>the mount has only one axis, so parts of its pointing model have no effect</source>
        <translation>a montagem só tem um eixo, por isso partes do seu modelo de apontamento não têm efeito</translation>
    </message>
    <message>
        <source>Set tilt, collimation and the other terms of the missing axis to 0.</source>
        <translation>Ponha a 0 a inclinação, a colimação e os outros termos do eixo que falta.</translation>
    </message>
    <message>
        <source>%1 needs %2 s and %3° to stop from %4°/s</source>
        <translation>o %1 precisa de %2 s e %3° para parar a partir de %4°/s</translation>
    </message>
    <message>
        <source>Raise max_acceleration_deg_s2 (%1), or lower max_speed_deg_s.</source>
        <translation>Aumente max_acceleration_deg_s2 (%1), ou reduza max_speed_deg_s.</translation>
    </message>
    <message>
        <source>%1 is the profile of the simulated mount. Set bus.name to the bus of the mount first.</source>
        <translation>%1 é o perfil da montagem simulada. Defina primeiro em bus.name o barramento da montagem.</translation>
    </message>
    <message>
        <source>%1: the place of the key was not found. Write %2 into the table %3.</source>
        <translation>%1: não se achou o lugar da chave. Escreva %2 na tabela %3.</translation>
    </message>
    <message>
        <source>%1 holds a password, and every user of this computer can read the file. Remove that right: chmod o-r %1</source>
        <translation>%1 contém uma palavra-passe, e qualquer utilizador deste computador pode ler o ficheiro. Retire essa permissão: chmod o-r %1</translation>
    </message>
    <message>
        <source>azimuth %1° is outside -3600°…3600°</source>
        <translation>o azimute %1° está fora de -3600°…3600°</translation>
    </message>
    <message>
        <source>refused: %1 clients of its host are connected</source>
        <translation>recusado: já estão conectados %1 clientes do mesmo computador</translation>
    </message>
    <message>
        <source>Real-time scheduling: not allowed. Install rtkit or raise the limit RLIMIT_RTPRIO.</source>
        <translation>Escalonamento em tempo real: não permitido. Instale rtkit ou aumente o limite RLIMIT_RTPRIO.</translation>
    </message>
    <message>
        <source>Real-time scheduling: on. Memory: locked in RAM.</source>
        <translation>Escalonamento em tempo real: ativo. Memória: fixada na RAM.</translation>
    </message>
    <message>
        <source>Real-time scheduling: on. Memory: not locked (limit RLIMIT_MEMLOCK).</source>
        <translation>Escalonamento em tempo real: ativo. Memória: não fixada (limite RLIMIT_MEMLOCK).</translation>
    </message>
    <message>
        <source>Boresight accepts every client</source>
        <translation>O Boresight aceita qualquer cliente</translation>
    </message>
    <message>
        <source>the profile was read again and is in force</source>
        <translation>o perfil foi lido de novo e está em vigor</translation>
    </message>
    <message>
        <source>The %1 stands at %2, outside its travel (%3 to %4). Jog it back slowly.</source>
        <translation>O %1 está em %2, fora do seu curso (%3 a %4). Traga-o de volta devagar com movimento manual.</translation>
    </message>
    <message>
        <source>The %1 stands outside its travel. It may only be jogged back inside.</source>
        <translation>O %1 está fora do seu curso. Só pode ser trazido de volta para dentro com movimento manual.</translation>
    </message>
    <message>
        <source>An axis stands outside its travel. Jog at %1°/s or slower.</source>
        <translation>Um eixo está fora do seu curso. Mova a %1°/s ou menos.</translation>
    </message>
    <message>
        <source>Boresight uses the profile as it is</source>
        <translation>O Boresight usa o perfil tal como é</translation>
    </message>
    <message>
        <source>the clock of this computer is not synchronised</source>
        <translation>o relógio deste computador não está sincronizado</translation>
    </message>
    <message>
        <source>%1 is outside the travel (%2 to %3) by more than %4. Enter the angle of the axis.</source>
        <translation>%1 está fora do curso (%2 a %3) por mais de %4. Escreva o ângulo do eixo.</translation>
    </message>
    <message>
        <source>%1 lines were lost: the disk did not store them in time</source>
        <translation>perderam-se %1 linhas: o disco não as guardou a tempo</translation>
    </message>
    <message>
        <source>With &quot;synchronised&quot; Boresight computes the Sun only from a clock that NTP or GPS set in the last 24 h. With &quot;trusted&quot; it uses the clock of this computer without that check.</source>
        <translation>Com &quot;synchronised&quot; o Boresight só calcula o Sol a partir de um relógio que o NTP ou o GPS acertou nas últimas 24 h. Com &quot;trusted&quot; usa o relógio deste computador sem essa verificação.</translation>
    </message>
    <message>
        <source>Lower max_acceleration_deg_s2 (%1), or raise max_torque_nm.</source>
        <translation>Reduza max_acceleration_deg_s2 (%1) ou aumente max_torque_nm.</translation>
    </message>
    <message>
        <source>fault %2: %3</source>
        <translation>falha %2: %3</translation>
    </message>
    <message>
        <source>%1 cannot be locked (%2). A program of another user may control this mount. Start Boresight as that user, or with another --state-dir</source>
        <translation>%1 não pode ser bloqueado (%2). Um programa de outro utilizador talvez controlo esta montagem. Inicie o Boresight como esse utilizador, ou com outro --state-dir</translation>
    </message>
    <message>
        <source>at the upper limit %1</source>
        <translation>no limite superior %1</translation>
    </message>
    <message>
        <source>at the lower limit %1</source>
        <translation>no limite inferior %1</translation>
    </message>
    <message>
        <source>every setting is right</source>
        <translation>todos os parâmetros estão certos</translation>
    </message>
    <message>
        <source>moteus mode %1, fault %2</source>
        <translation>modo moteus %1, falha %2</translation>
    </message>
    <message>
        <source>This rotator has no watchdog of its own</source>
        <translation>Este rotor não tem watchdog próprio</translation>
    </message>
    <message>
        <source>This mount has no azimuth axis.</source>
        <translation>Esta montagem não tem eixo de azimute.</translation>
    </message>
    <message>
        <source>This mount has no elevation axis.</source>
        <translation>Esta montagem não tem eixo de elevação.</translation>
    </message>
    <message>
        <source>NONE</source>
        <comment>axis state</comment>
        <translation>NENHUM</translation>
    </message>
    <message>
        <source>A mount needs at least one axis.</source>
        <translation>Uma montagem precisa de pelo menos um eixo.</translation>
    </message>
    <message>
        <source>%1 (magnetic model)</source>
        <translation>%1 (modelo magnético)</translation>
    </message>
    <message>
        <source>%1 (entered)</source>
        <translation>%1 (introduzida)</translation>
    </message>
    <message>
        <source>The declination of this site is not known. Enter it, or enter the site and the file of the magnetic model.</source>
        <translation>A declinação deste local não é conhecida. Introduza-a, ou introduza o local e o ficheiro do modelo magnético.</translation>
    </message>
    <message>
        <source>The sensor applies the declination (%1). Boresight adds nothing.</source>
        <translation>O sensor aplica a declinação (%1). O Boresight não soma nada.</translation>
    </message>
    <message>
        <source>Boresight adds a declination of %2 and removes the sensor&apos;s %1. The sum is %3.</source>
        <translation>O Boresight soma uma declinação de %2 e retira %1 do sensor. A soma é %3.</translation>
    </message>
    <message>
        <source>Boresight cannot apply the declination. %1</source>
        <translation>O Boresight não consegue aplicar a declinação. %1</translation>
    </message>
    <message>
        <source>The declination here is %1, but the sensor added %2. Its headings are off by %3.</source>
        <translation>A declinação aqui é %1, mas o sensor somou %2. Os rumos dele têm um erro de %3.</translation>
    </message>
    <message>
        <source>This calibration belongs to the mount at %2, but the bus of the profile is now %1. Set the bus back, or press Reconnect and calibrate again.</source>
        <translation>Esta calibração é da montagem em %2, mas o barramento do perfil é agora %1. Reponha o barramento, ou prima Reconectar e calibre de novo.</translation>
    </message>
    <message>
        <source>The bus cannot change between simulated and real while the mount is connected. Press Reconnect, or restart Boresight.</source>
        <translation>O barramento não pode mudar entre simulado e real enquanto a montagem está ligada. Prima Reconectar, ou reinicie o Boresight.</translation>
    </message>
    <message>
        <source>Boresight does not stop the mount</source>
        <translation>O Boresight não para a montagem</translation>
    </message>
    <message>
        <source>Boresight stopped the mount and holds it</source>
        <translation>O Boresight parou a montagem e mantém-na</translation>
    </message>
    <message>
        <source>Lower the acceleration, set servo.max_regen_power_W, or add a battery or a brake resistor.</source>
        <translation>Baixe a aceleração, defina servo.max_regen_power_W, ou acrescente uma bateria ou uma resistência de travagem.</translation>
    </message>
    <message>
        <source>Let the motor cool down. Look for friction or a load out of balance.</source>
        <translation>Deixe o motor arrefecer. Procure atrito ou uma carga desequilibrada.</translation>
    </message>
    <message>
        <source>The %1 timed out because it received no command in time</source>
        <translation>O %1 excedeu o tempo porque não recebeu nenhum comando a tempo</translation>
    </message>
    <message>
        <source>The watchdog stopped the drive. Boresight ended the motion of the mount</source>
        <translation>O watchdog parou o acionamento. O Boresight terminou o movimento da montagem</translation>
    </message>
    <message>
        <source>Boresight ended the motion. Each axis holds if its drive still can</source>
        <translation>O Boresight terminou o movimento. Cada eixo mantém-se se o seu acionamento ainda puder</translation>
    </message>
    <message>
        <source>The %1 reports no credible position</source>
        <translation>O %1 não comunica nenhuma posição credível</translation>
    </message>
    <message>
        <source>Boresight ended the motion of the mount and commanded this drive to brake and hold</source>
        <translation>O Boresight terminou o movimento da montagem e mandou este acionamento travar e manter</translation>
    </message>
    <message>
        <source>The %1 answers but does not follow its commands</source>
        <translation>O %1 responde mas não cumpre os comandos</translation>
    </message>
    <message>
        <source>Boresight ended the motion. If the drive has power, its watchdog brakes it after %2 s</source>
        <translation>O Boresight terminou o movimento. Se o acionamento tiver energia, o seu watchdog trava-o após %2 s</translation>
    </message>
    <message>
        <source>Boresight sends no motion commands</source>
        <translation>O Boresight não envia comandos de movimento</translation>
    </message>
    <message>
        <source>The drive gives less than Boresight commands</source>
        <translation>O acionamento dá menos do que o Boresight comanda</translation>
    </message>
    <message>
        <source>Pointing is blocked and clients get no position. Slow jog still works</source>
        <translation>O apontamento está bloqueado e os clientes não recebem posição. O jog lento continua a funcionar</translation>
    </message>
    <message>
        <source>Boresight did not use --standing-at for the %1: %2</source>
        <translation>O Boresight não usou --standing-at para o %1: %2</translation>
    </message>
    <message>
        <source>Pointing continues, because the sensor is only a cross-check</source>
        <translation>O apontamento continua, porque o sensor é só uma verificação independente</translation>
    </message>
    <message>
        <source>The orientation sensor sends only zeros</source>
        <translation>O sensor de orientação envia só zeros</translation>
    </message>
    <message>
        <source>Pointing is unchanged, because the sensor is only a cross-check</source>
        <translation>O apontamento não muda, porque o sensor é só uma verificação independente</translation>
    </message>
    <message>
        <source>Pointing is unchanged. Until north is set, azimuths are axis angles</source>
        <translation>O apontamento não muda. Até o norte ser definido, os azimutes são ângulos do eixo</translation>
    </message>
    <message>
        <source>The clock of this computer is not synchronised, so the position of the Sun is unknown</source>
        <translation>O relógio deste computador não está sincronizado, por isso a posição do Sol é desconhecida</translation>
    </message>
    <message>
        <source>Boresight refuses motions to every position that the Sun can have</source>
        <translation>O Boresight recusa movimentos para qualquer posição que o Sol possa ter</translation>
    </message>
    <message>
        <source>Keep clear of the mount. STOP or Hold ends the swing</source>
        <translation>Afaste-se da montagem. STOP ou Manter termina a compensação</translation>
    </message>
    <message>
        <source>Boresight no longer uses any of them</source>
        <translation>O Boresight já não usa nenhum deles</translation>
    </message>
    <message>
        <source>Boresight continues to use the bus</source>
        <translation>O Boresight continua a usar o barramento</translation>
    </message>
    <message>
        <source>Check the plugs, the cable and the termination of the bus</source>
        <translation>Verifique as fichas, o cabo e a terminação do barramento</translation>
    </message>
    <message>
        <source>Boresight keeps the position of the axes in memory only</source>
        <translation>O Boresight guarda a posição dos eixos só na memória</translation>
    </message>
    <message>
        <source>Boresight keeps the log in memory only</source>
        <translation>O Boresight guarda o registo só na memória</translation>
    </message>
    <message>
        <source>Boresight moves nothing</source>
        <translation>O Boresight não move nada</translation>
    </message>
    <message>
        <source>Boresight moves nothing, because commands would reach the wrong axis</source>
        <translation>O Boresight não move nada, porque os comandos chegariam ao eixo errado</translation>
    </message>
    <message>
        <source>Boresight read the settings again</source>
        <translation>O Boresight leu de novo as configurações</translation>
    </message>
    <message>
        <source>The window hides the old numbers</source>
        <translation>A janela oculta os números antigos</translation>
    </message>
    <message>
        <source>position journal</source>
        <translation>diário de posição</translation>
    </message>
    <message>
        <source> (limit %1 of the drive: %2)</source>
        <translation> (limite %1 do acionamento: %2)</translation>
    </message>
    <message>
        <source>The mount tracks the Sun until you command another motion</source>
        <translation>A montagem segue o Sol até comandar outro movimento</translation>
    </message>
    <message>
        <source>This lasts until the mount moves or the Sun has passed</source>
        <translation>Isto dura até a montagem se mover ou o Sol ter passado</translation>
    </message>
    <message>
        <source>%1 moved by %2 to %3 although it has to hold its position</source>
        <translation>%1 moveu-se %2 até %3, embora deva manter a posição</translation>
    </message>
    <message>
        <source>the reported angle of %1 jumped by %2 in %3 to %4, faster than the axis can move</source>
        <translation>o ângulo comunicado de %1 saltou %2 em %3 para %4, mais depressa do que o eixo se pode mover</translation>
    </message>
    <message>
        <source>the check of %1 ended early: %2</source>
        <translation>a verificação de %1 terminou antes do tempo: %2</translation>
    </message>
    <message>
        <source>nothing was stored in %1, because %2 was set to %3 and reads back %4</source>
        <translation>nada foi guardado em %1, porque %2 foi definido para %3 e lê-se %4</translation>
    </message>
    <message>
        <source>two boards have the id %1, so their answers collide</source>
        <translation>duas placas têm o id %1, por isso as suas respostas colidem</translation>
    </message>
    <message>
        <source>a board with the id %1 (%2) is not in the profile</source>
        <translation>uma placa com o id %1 (%2) não está no perfil</translation>
    </message>
    <message>
        <source>the ids are swapped, and the board with the id %1 (%2) was the board of %3</source>
        <translation>os ids estão trocados, e a placa com o id %1 (%2) era a placa de %3</translation>
    </message>
    <message>
        <source>the board of %1 (id %2) does not answer</source>
        <translation>a placa de %1 (id %2) não responde</translation>
    </message>
    <message>
        <source>%1 has another board than before (%2)</source>
        <translation>%1 tem outra placa do que antes (%2)</translation>
    </message>
    <message>
        <source>Check the power of the drives, the bus cable, and the 120 Ω at both ends.</source>
        <translation>Verifique a energia dos acionamentos, o cabo do barramento, e os 120 Ω nas duas pontas.</translation>
    </message>
    <message>
        <source>The sensor repeats one value to the last digit. Switch it off and on</source>
        <translation>O sensor repete um valor até ao último dígito. Desligue-o e ligue-o</translation>
    </message>
    <message>
        <source>Boresight starts no motion and allows only motions away from the Sun</source>
        <translation>O Boresight não inicia movimentos e só permite os que se afastem do Sol</translation>
    </message>
    <message>
        <source>Power-cycle the drive. Check the wiring and configuration of its aux ports</source>
        <translation>Desligue e ligue o acionamento. Verifique a cablagem e a configuração das portas auxiliares</translation>
    </message>
    <message>
        <source>Let it cool down. Lower the torque or improve the cooling</source>
        <translation>Deixe arrefecer. Baixe o binário ou melhore o arrefecimento</translation>
    </message>
    <message>
        <source>Factory bounds of ±0.01 turns, a wrong cable wrap after power-up, or an axis moved by hand</source>
        <translation>Limites de fábrica de ±0,01 voltas, uma volta do cabo errada após ligar, ou um eixo movido à mão</translation>
    </message>
    <message>
        <source>Check the supply at the board (at least 10 V). If it is right, replace the board</source>
        <translation>Verifique a alimentação na placa (pelo menos 10 V). Se estiver certa, substitua a placa</translation>
    </message>
    <message>
        <source>A mistake in the drive&apos;s configuration</source>
        <translation>Um erro na configuração do acionamento</translation>
    </message>
    <message>
        <source>A position beyond the drive&apos;s own bounds was commanded, or the axis was pushed there</source>
        <translation>Foi comandada uma posição além dos limites do acionamento, ou o eixo foi empurrado para lá</translation>
    </message>
    <message>
        <source>%1 moved by %2 to %3 without a command (weight, wind, a hand or another program)</source>
        <translation>%1 moveu-se %2 até %3 sem comando (peso, vento, uma mão ou outro programa)</translation>
    </message>
    <message>
        <source>The drives have just come back. Wait a second.</source>
        <translation>Os acionamentos acabaram de voltar. Espere um segundo.</translation>
    </message>
    <message>
        <source>STOP is latched. Reset STOP first.</source>
        <translation>STOP está retido. Reponha STOP primeiro.</translation>
    </message>
    <message>
        <source>%1. Re-arm first.</source>
        <translation>%1. Rearme primeiro.</translation>
    </message>
    <message>
        <source>every drive answers, and nothing moves</source>
        <translation>todos os acionamentos respondem, e nada se move</translation>
    </message>
    <message>
        <source>the bus is released to other tools</source>
        <translation>o barramento está libertado para outras ferramentas</translation>
    </message>
    <message>
        <source>The operator has control. Only the operator can re-arm.</source>
        <translation>O operador tem o controlo. Só o operador pode rearmar.</translation>
    </message>
    <message>
        <source>re-arms. Drives in fault or time-out are stopped first</source>
        <translation>rearma. Os acionamentos em falha ou tempo excedido são parados primeiro</translation>
    </message>
    <message>
        <source>re-arms by the recovery policy of the profile, and nothing moves by itself</source>
        <translation>rearma pela política de recuperação do perfil, e nada se move sozinho</translation>
    </message>
    <message>
        <source>may no longer move the mount, so the mount holds</source>
        <translation>já não pode mover a montagem, por isso a montagem mantém</translation>
    </message>
    <message>
        <source>ends the motion, and the mount holds</source>
        <translation>termina o movimento, e a montagem mantém</translation>
    </message>
    <message>
        <source>the client that sent last has control</source>
        <translation>o cliente que enviou por último tem o controlo</translation>
    </message>
    <message>
        <source>%1 received control %2.</source>
        <translation>%1 recebeu o controlo %2.</translation>
    </message>
    <message>
        <source>%1 has control. It sent its last command %2.</source>
        <translation>%1 tem o controlo. Enviou o último comando %2.</translation>
    </message>
    <message>
        <source>The operator has made this client read-only.</source>
        <translation>O operador pôs este cliente só de leitura.</translation>
    </message>
    <message>
        <source>The mount is locked to %1.</source>
        <translation>A montagem está reservada a %1.</translation>
    </message>
    <message>
        <source>this client has disconnected</source>
        <translation>este cliente desligou-se</translation>
    </message>
    <message>
        <source>The mount is locked to %1. Unlock it first.</source>
        <translation>A montagem está reservada a %1. Liberte-a primeiro.</translation>
    </message>
    <message>
        <source>The %1 reports no position. Check its encoder.</source>
        <translation>O %1 não comunica posição. Verifique o encoder.</translation>
    </message>
    <message>
        <source>The directions of the axes are not confirmed. Jog each axis a little and confirm them first.</source>
        <translation>Os sentidos dos eixos não estão confirmados. Faça jog um pouco em cada eixo e confirme-os primeiro.</translation>
    </message>
    <message>
        <source>Boresight is finding the position of the axes. Wait a moment.</source>
        <translation>O Boresight está a determinar a posição dos eixos. Espere um momento.</translation>
    </message>
    <message>
        <source>The cable wrap of an axis is unknown. Jog at %1°/s or slower.</source>
        <translation>A volta do cabo de um eixo é desconhecida. Faça jog a %1°/s ou menos.</translation>
    </message>
    <message>
        <source>The mount moves. Stop it first.</source>
        <translation>A montagem move-se. Pare-a primeiro.</translation>
    </message>
    <message>
        <source>Boresight is taking over a drive. Try again in a second.</source>
        <translation>O Boresight está a assumir um acionamento. Tente de novo dentro de um segundo.</translation>
    </message>
    <message>
        <source>The clock of this computer is not synchronised, so the Sun may be in the beam. Only the operator may jog the mount out, at %1°/s or slower.</source>
        <translation>O relógio deste computador não está sincronizado, por isso o Sol pode estar no feixe. Só o operador pode tirar a montagem por jog, a %1°/s ou menos.</translation>
    </message>
    <message>
        <source>goes to the nearest permitted point because of a limit (%1)</source>
        <translation>vai para o ponto permitido mais próximo devido a um limite (%1)</translation>
    </message>
    <message>
        <source>takes control, and Boresight refuses motion commands of clients</source>
        <translation>toma o controlo, e o Boresight recusa comandos de movimento dos clientes</translation>
    </message>
    <message>
        <source>switches the drives off, so nothing holds the mount</source>
        <translation>desliga os acionamentos, por isso nada mantém a montagem</translation>
    </message>
    <message>
        <source>takes the bus back, and reads the drives again</source>
        <translation>retoma o barramento, e lê de novo os acionamentos</translation>
    </message>
    <message>
        <source>the position of the Sun is known again</source>
        <translation>a posição do Sol é conhecida de novo</translation>
    </message>
    <message>
        <source>STOP is latched, and the mount decelerates and holds</source>
        <translation>STOP está retido, e a montagem desacelera e mantém</translation>
    </message>
    <message>
        <source>The mount is still braking. Reset STOP when it stands still.</source>
        <translation>A montagem ainda está a travar. Reponha STOP quando estiver parada.</translation>
    </message>
    <message>
        <source>resets STOP, and nothing moves until the next command</source>
        <translation>repõe STOP, e nada se move até ao próximo comando</translation>
    </message>
    <message>
        <source>jog ends at 2° until the directions of the axes are confirmed</source>
        <translation>o jog termina aos 2° até os sentidos dos eixos serem confirmados</translation>
    </message>
    <message>
        <source>the cable wrap of an axis is unknown</source>
        <translation>a volta do cabo de um eixo é desconhecida</translation>
    </message>
    <message>
        <source>re-armed, and nothing moves</source>
        <translation>rearmado, e nada se move</translation>
    </message>
    <message>
        <source>wrap unknown</source>
        <translation>volta desconhecida</translation>
    </message>
    <message>
        <source>not commanded by Boresight</source>
        <translation>não comandado pelo Boresight</translation>
    </message>
    <message>
        <source>The bus is released to other tools. Take the bus back first.</source>
        <translation>O barramento está libertado para outras ferramentas. Retome-o primeiro.</translation>
    </message>
    <message>
        <source>the bus is not released to other tools</source>
        <translation>o barramento não está libertado para outras ferramentas</translation>
    </message>
    <message>
        <source>No moteus turns this axis.</source>
        <translation>Nenhum moteus move este eixo.</translation>
    </message>
    <message>
        <source>The directions of the axes are not confirmed. Jog at 5°/s or slower, or confirm them.</source>
        <translation>Os sentidos dos eixos não estão confirmados. Faça jog a 5°/s ou menos, ou confirme-os.</translation>
    </message>
    <message>
        <source>The directions of the axes are not confirmed. Until then an axis moves at most 2°.</source>
        <translation>Os sentidos dos eixos não estão confirmados. Até lá um eixo move-se no máximo 2°.</translation>
    </message>
    <message>
        <source>%1 to %2%3</source>
        <translation>%1 a %2%3</translation>
    </message>
    <message>
        <source>Not enough room for a crash stop of the %1 at %2°/s. Move it away from both ends of its travel.</source>
        <translation>Sem espaço para uma paragem de emergência do %1 a %2°/s. Afaste-o dos dois fins do curso.</translation>
    </message>
    <message>
        <source>The %1 did not stop within %2 s without commands. Check its time-out mode.</source>
        <translation>O %1 não parou em %2 s sem comandos. Verifique o seu modo de tempo excedido.</translation>
    </message>
    <message>
        <source>was power-cycled, so its cable wrap is judged again</source>
        <translation>foi desligado e ligado, por isso a volta do cabo é avaliada de novo</translation>
    </message>
    <message>
        <source>The %1 is switched on. Support the elevation and switch the drives off first.</source>
        <translation>O %1 está ligado. Apoie a elevação e desligue primeiro os acionamentos.</translation>
    </message>
    <message>
        <source>ended because the drive no longer reports a position</source>
        <translation>terminou porque o acionamento já não comunica posição</translation>
    </message>
    <message>
        <source>this computer stalled for %1 s, and drives may have stopped by their watchdog</source>
        <translation>este computador parou %1 s, e os acionamentos podem ter parado pelo seu watchdog</translation>
    </message>
    <message>
        <source>position confirmed</source>
        <translation>posição confirmada</translation>
    </message>
    <message>
        <source>the cable wrap is unknown, so pointing is blocked until the operator enters the position</source>
        <translation>a volta do cabo é desconhecida, por isso o apontamento está bloqueado até o operador introduzir a posição</translation>
    </message>
    <message>
        <source>The drive is busy. Try again in a second.</source>
        <translation>O acionamento está ocupado. Tente de novo dentro de um segundo.</translation>
    </message>
    <message>
        <source>%1 is beyond the bounds of the drive, which would pull the axis back at once. Support the elevation and switch the drives off first.</source>
        <translation>%1 está além dos limites do acionamento, que puxaria logo o eixo de volta. Apoie a elevação e desligue primeiro os acionamentos.</translation>
    </message>
    <message>
        <source>jog ends because its keep-alive did not come</source>
        <translation>o jog termina porque o seu sinal de vida não chegou</translation>
    </message>
    <message>
        <source>This Gpredict updates only every %1°. Set Threshold to 0.1 in its Antenna Control.</source>
        <translation>Este Gpredict só atualiza a cada %1°. Defina Threshold para 0.1 no seu Antenna Control.</translation>
    </message>
    <message>
        <source>reconnects to the mount &quot;%1&quot;</source>
        <translation>religa-se à montagem &quot;%1&quot;</translation>
    </message>
    <message>
        <source>No mount was connected at that moment. Try again.</source>
        <translation>Nesse momento não estava ligada nenhuma montagem. Tente de novo.</translation>
    </message>
    <message>
        <source>A text in double quotes does not end in its line.</source>
        <translation>Um texto entre aspas não termina na sua linha.</translation>
    </message>
    <message>
        <source>%1 is %2. SGP4 needs %3.</source>
        <translation>%1 é %2. O SGP4 precisa de %3.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>Falta %1.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;. This cannot be read.</source>
        <translation>%1 é &quot;%2&quot;. Não é possível ler isto.</translation>
    </message>
    <message>
        <source>The XML has no element &lt;omm&gt;.</source>
        <translation>O XML não tem nenhum elemento &lt;omm&gt;.</translation>
    </message>
    <message>
        <source>The time is more than 100 years from the epoch of the elements.</source>
        <translation>A hora está a mais de 100 anos da época dos elementos.</translation>
    </message>
    <message>
        <source>The line has %1 columns instead of 69.</source>
        <translation>A linha tem %1 colunas em vez de 69.</translation>
    </message>
    <message>
        <source>The line continues after column 69.</source>
        <translation>A linha continua depois da coluna 69.</translation>
    </message>
    <message>
        <source>Column %1 is not blank. Is a column missing or added?</source>
        <translation>A coluna %1 não está em branco. Falta ou sobra uma coluna?</translation>
    </message>
    <message>
        <source>the catalogue number</source>
        <translation>o número de catálogo</translation>
    </message>
    <message>
        <source>The checksum in column 69 is &quot;%1&quot;, expected %2.</source>
        <translation>A soma de verificação na coluna 69 é &quot;%1&quot;, esperava-se %2.</translation>
    </message>
    <message>
        <source>the year of the epoch</source>
        <translation>o ano da época</translation>
    </message>
    <message>
        <source>the day of the epoch</source>
        <translation>o dia da época</translation>
    </message>
    <message>
        <source>The day %1 of the epoch is not in the year %2.</source>
        <translation>O dia %1 da época não existe no ano %2.</translation>
    </message>
    <message>
        <source>the first derivative of the mean motion</source>
        <translation>a primeira derivada do movimento médio</translation>
    </message>
    <message>
        <source>the second derivative of the mean motion</source>
        <translation>a segunda derivada do movimento médio</translation>
    </message>
    <message>
        <source>the drag term</source>
        <translation>o termo de arrasto</translation>
    </message>
    <message>
        <source>the ephemeris type</source>
        <translation>o tipo de efeméride</translation>
    </message>
    <message>
        <source>The set is made for SGP4-XP (ephemeris type 4), not for SGP4.</source>
        <translation>O conjunto é feito para o SGP4-XP (tipo de efeméride 4), não para o SGP4.</translation>
    </message>
    <message>
        <source>the set number</source>
        <translation>o número do conjunto</translation>
    </message>
    <message>
        <source>Line 1 has the catalogue number %1, line 2 has %2.</source>
        <translation>A linha 1 tem o número de catálogo %1, a linha 2 tem %2.</translation>
    </message>
    <message>
        <source>the inclination</source>
        <translation>a inclinação</translation>
    </message>
    <message>
        <source>the ascending node</source>
        <translation>o nodo ascendente</translation>
    </message>
    <message>
        <source>the eccentricity</source>
        <translation>a excentricidade</translation>
    </message>
    <message>
        <source>the argument of the perigee</source>
        <translation>o argumento do perigeu</translation>
    </message>
    <message>
        <source>the mean anomaly</source>
        <translation>a anomalia média</translation>
    </message>
    <message>
        <source>the mean motion</source>
        <translation>o movimento médio</translation>
    </message>
    <message>
        <source>the revolution number</source>
        <translation>o número da revolução</translation>
    </message>
    <message>
        <source>There is no line 1 before this line 2.</source>
        <translation>Não há linha 1 antes desta linha 2.</translation>
    </message>
    <message>
        <source>There is no line 2 after this line 1.</source>
        <translation>Não há linha 2 depois desta linha 1.</translation>
    </message>
    <message>
        <source>The catalogue number is %1. It must be from 0 to 999999999.</source>
        <translation>O número de catálogo é %1. Tem de estar entre 0 e 999999999.</translation>
    </message>
    <message>
        <source>The eccentricity is %1. It must be at least 0 and below 1.</source>
        <translation>A excentricidade é %1. Tem de ser pelo menos 0 e inferior a 1.</translation>
    </message>
    <message>
        <source>The mean motion is %1 rev/day. It must be above 0.</source>
        <translation>O movimento médio é %1 rev/dia. Tem de ser superior a 0.</translation>
    </message>
    <message>
        <source>The inclination is %1°. It must be from 0° to 180°.</source>
        <translation>A inclinação é %1°. Tem de estar entre 0° e 180°.</translation>
    </message>
    <message>
        <source>An angle is %1°. It must be from -360° to 360°.</source>
        <translation>Um ângulo é %1°. Tem de estar entre -360° e 360°.</translation>
    </message>
    <message>
        <source>The line has %1 values. The header has %2.</source>
        <translation>A linha tem %1 valores. O cabeçalho tem %2.</translation>
    </message>
    <message>
        <source>This is not a JSON object: %1.</source>
        <translation>Isto não é um objeto JSON: %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an element set in JSON.</source>
        <translation>&quot;%1&quot; não é um conjunto de elementos em JSON.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a line of the form KEY = value.</source>
        <translation>&quot;%1&quot; não é uma linha da forma CHAVE = valor.</translation>
    </message>
    <message>
        <source>This is not valid XML: %1</source>
        <translation>Isto não é XML válido: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not part of an element set.</source>
        <translation>&quot;%1&quot; não faz parte de um conjunto de elementos.</translation>
    </message>
    <message>
        <source>The mean eccentricity is outside the range 0 to 1. The elements are not valid at this time.</source>
        <translation>A excentricidade média está fora do intervalo de 0 a 1. Os elementos não são válidos a esta hora.</translation>
    </message>
    <message>
        <source>The mean motion is not above 0. The elements are not valid at this time.</source>
        <translation>O movimento médio não é superior a 0. Os elementos não são válidos a esta hora.</translation>
    </message>
    <message>
        <source>Sun and Moon move the eccentricity out of the range 0 to 1. The elements are not valid at this time.</source>
        <translation>O Sol e a Lua levam a excentricidade para fora do intervalo de 0 a 1. Os elementos não são válidos a esta hora.</translation>
    </message>
    <message>
        <source>The orbit is not an ellipse. The elements are not valid at this time.</source>
        <translation>A órbita não é uma elipse. Os elementos não são válidos a esta hora.</translation>
    </message>
    <message>
        <source>The satellite has decayed. Its orbit is below the surface of the Earth.</source>
        <translation>O satélite reentrou na atmosfera. A sua órbita está abaixo da superfície da Terra.</translation>
    </message>
    <message>
        <source>Columns %1 to %2 (%3) hold &quot;%4&quot;. This is not a number.</source>
        <translation>As colunas %1 a %2 (%3) contêm &quot;%4&quot;. Isto não é um número.</translation>
    </message>
    <message>
        <source>%1: There is no file of elements in this folder.</source>
        <translation>%1: Não há nenhum ficheiro de elementos nesta pasta.</translation>
    </message>
    <message>
        <source>%1: %2 further problems are not listed.</source>
        <translation>%1: Há mais %2 problemas que não estão na lista.</translation>
    </message>
    <message>
        <source>%1: There is no element set in this file.</source>
        <translation>%1: Não há nenhum conjunto de elementos neste ficheiro.</translation>
    </message>
    <message>
        <source>%1: There are no elements of satellite %2 in %3. Update them in Gpredict.</source>
        <translation>%1: Não há elementos do satélite %2 em %3. Atualize-os no Gpredict.</translation>
    </message>
    <message>
        <source>%1: The module names no satellite.</source>
        <translation>%1: O módulo não indica nenhum satélite.</translation>
    </message>
    <message>
        <source>%1 Then press Re-arm</source>
        <translation>%1 Depois prima Rearmar</translation>
    </message>
    <message>
        <source>Re-arm</source>
        <translation>Rearmar</translation>
    </message>
    <message>
        <source>Reset stop</source>
        <translation>Repor STOP</translation>
    </message>
    <message>
        <source>Unwrap now</source>
        <translation>Desenrolar já</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconectar</translation>
    </message>
    <message>
        <source>Move park</source>
        <translation>Mover estacionamento</translation>
    </message>
    <message>
        <source>Open Protection</source>
        <translation>Abrir Proteção</translation>
    </message>
    <message>
        <source>Open Drives</source>
        <translation>Abrir Acionamentos</translation>
    </message>
    <message>
        <source>Open Clients</source>
        <translation>Abrir Clientes</translation>
    </message>
    <message>
        <source>Open Limits</source>
        <translation>Abrir Limites</translation>
    </message>
    <message>
        <source>Open North</source>
        <translation>Abrir Norte</translation>
    </message>
    <message>
        <source>Open Profile</source>
        <translation>Abrir Perfil</translation>
    </message>
    <message>
        <source>Enter position</source>
        <translation>Indicar posição</translation>
    </message>
    <message>
        <source>Look for wind, ice or a tight cable. If there is none, lower the acceleration or check the gains.</source>
        <translation>Procure vento, gelo ou um cabo esticado. Se não houver, baixe a aceleração ou verifique os ganhos.</translation>
    </message>
    <message>
        <source>Calibrate the motor again. Check its phases and the encoder.</source>
        <translation>Calibre o motor de novo. Verifique as fases e o codificador.</translation>
    </message>
    <message>
        <source>Compare the shown angle with the antenna. Check the encoder, its wiring and other programs on the bus.</source>
        <translation>Compare o ângulo mostrado com a antena. Verifique o codificador, a sua cablagem e outros programas no barramento.</translation>
    </message>
    <message>
        <source>Cool and shade the board, or move less. At its limit the drive switches itself off.</source>
        <translation>Arrefeça e proteja a placa do sol, ou mova menos. No seu limite o acionamento desliga-se.</translation>
    </message>
    <message>
        <source>The %1 reports fault %2: %3</source>
        <translation>O %1 comunica a falha %2: %3</translation>
    </message>
    <message>
        <source>The %1 is in fault without a fault code</source>
        <translation>O %1 está em falha sem código de falha</translation>
    </message>
    <message>
        <source>in fault without a fault code</source>
        <translation>em falha sem código de falha</translation>
    </message>
    <message>
        <source>Check the bus and the load of this computer.</source>
        <translation>Verifique o barramento e a carga deste computador.</translation>
    </message>
    <message>
        <source>The %1 does not reply</source>
        <translation>O %1 não responde</translation>
    </message>
    <message>
        <source>Look for a loose plug, a worn cable or a weak supply.</source>
        <translation>Procure uma ficha solta, um cabo gasto ou uma alimentação fraca.</translation>
    </message>
    <message>
        <source>The %1 reports limit %2: %3</source>
        <translation>O %1 comunica o limite %2: %3</translation>
    </message>
    <message>
        <source>limit %2: %3</source>
        <translation>limite %2: %3</translation>
    </message>
    <message>
        <source>The %1 is active (mode: %2) without a command from Boresight</source>
        <translation>O %1 está ativo (modo: %2) sem comando do Boresight</translation>
    </message>
    <message>
        <source>The cable wrap of the %1 is unknown</source>
        <translation>A volta do cabo do %1 é desconhecida</translation>
    </message>
    <message>
        <source>Look at the mount and its cable. Then enter the position of the axis</source>
        <translation>Olhe para a montagem e o cabo. Depois indique a posição do eixo</translation>
    </message>
    <message>
        <source>Enter the position of the axis in the window. Without a window, restart with the present position and time</source>
        <translation>Indique a posição do eixo na janela. Sem janela, reinicie com a posição e a hora presentes</translation>
    </message>
    <message>
        <source>The orientation sensor (%1) sends no data</source>
        <translation>O sensor de orientação (%1) não envia dados</translation>
    </message>
    <message>
        <source>North is not set: the orientation sensor and the axes differ by %1 in azimuth</source>
        <translation>O norte não está definido: o sensor de orientação e os eixos diferem %1 em azimute</translation>
    </message>
    <message>
        <source>Find north on the page North. If the axis zero is north, check the mounting of the sensor and the coupling</source>
        <translation>Encontre o norte na página Norte. Se o zero do eixo for o norte, verifique a montagem do sensor e o acoplamento</translation>
    </message>
    <message>
        <source>Move the mount away, or wait until the Sun has passed. The setting keep_away (Sun) turns this rule off</source>
        <translation>Afaste a montagem, ou espere até o Sol passar. O parâmetro keep_away (Sol) desliga esta regra</translation>
    </message>
    <message>
        <source>Synchronise the clock by NTP or GPS. If its time is right, set clock (Sun) to trusted on the page Profile</source>
        <translation>Sincronize o relógio por NTP ou GPS. Se a hora estiver certa, ponha clock (Sol) em trusted na página Perfil</translation>
    </message>
    <message>
        <source>The antenna points at the Sun, or moves to it</source>
        <translation>A antena aponta para o Sol, ou move-se para ele</translation>
    </message>
    <message>
        <source>Never look along the beam or a sight tube without a solar filter. Protect the feed of a dish from the heat</source>
        <translation>Nunca olhe ao longo do feixe ou de um tubo de mira sem filtro solar. Proteja do calor o alimentador de um prato</translation>
    </message>
    <message>
        <source>The compass swing waits for its sensor</source>
        <translation>O giro da bússola espera pelo sensor</translation>
    </message>
    <message>
        <source>The mount stands still. It moves again BY ITSELF if sensor data returns before %1</source>
        <translation>A montagem está parada. Volta a mover-se POR SI se os dados do sensor voltarem antes das %1</translation>
    </message>
    <message>
        <source>The model stays in force. Boresight moves nothing because of this</source>
        <translation>O modelo continua em vigor. O Boresight não move nada por causa disto</translation>
    </message>
    <message>
        <source>Find north again on the page North and apply it, or undo the calibration</source>
        <translation>Encontre o norte de novo na página Norte e aplique-o, ou anule a calibração</translation>
    </message>
    <message>
        <source>The history of the calibration is not stored: %1</source>
        <translation>O histórico da calibração não está guardado: %1</translation>
    </message>
    <message>
        <source>Check the disk, or choose another folder with --state-dir. After a restart Undo is not possible</source>
        <translation>Verifique o disco, ou escolha outra pasta com --state-dir. Depois de um reinício não é possível anular</translation>
    </message>
    <message>
        <source>The points on the page Sun/Moon were taken with another drive</source>
        <translation>Os pontos na página Sol/Lua foram tomados com outro acionamento</translation>
    </message>
    <message>
        <source>The points on the page Sun/Moon were taken at another site</source>
        <translation>Os pontos na página Sol/Lua foram tomados noutro local</translation>
    </message>
    <message>
        <source>The CAN bus is down: %1</source>
        <translation>O barramento CAN está em baixo: %1</translation>
    </message>
    <message>
        <source>Boresight can command nothing. It tries to open the bus again each second</source>
        <translation>O Boresight não pode comandar nada. Tenta abrir o barramento de novo a cada segundo</translation>
    </message>
    <message>
        <source>The CAN bus is closed: %1</source>
        <translation>O barramento CAN está fechado: %1</translation>
    </message>
    <message>
        <source>Boresight can command nothing. It sends nothing more to this port</source>
        <translation>O Boresight não pode comandar nada. Não envia mais nada a esta porta</translation>
    </message>
    <message>
        <source>The CAN bus is disturbed: %1</source>
        <translation>O barramento CAN está perturbado: %1</translation>
    </message>
    <message>
        <source>This computer stalled for %1 s, so the watchdogs stopped the drives</source>
        <translation>Este computador parou %1 s, por isso os watchdogs pararam os acionamentos</translation>
    </message>
    <message>
        <source>Boresight takes the drives over again and resumes the motion</source>
        <translation>O Boresight volta a assumir os acionamentos e retoma o movimento</translation>
    </message>
    <message>
        <source>Nothing to do. If this happens often, reduce the load of this computer</source>
        <translation>Nada a fazer. Se acontecer muitas vezes, reduza a carga deste computador</translation>
    </message>
    <message>
        <source>Clients cannot connect: %1</source>
        <translation>Os clientes não podem conectar-se: %1</translation>
    </message>
    <message>
        <source>Boresight does everything else without clients</source>
        <translation>O Boresight faz tudo o resto sem clientes</translation>
    </message>
    <message>
        <source>End the other program, or choose another port (rotctld.listen on the page Profile). Then restart Boresight</source>
        <translation>Termine o outro programa, ou escolha outra porta (rotctld.listen na página Perfil). Depois reinicie o Boresight</translation>
    </message>
    <message>
        <source>Every computer that reaches %1 can move the mount</source>
        <translation>Qualquer computador que alcance %1 pode mover a montagem</translation>
    </message>
    <message>
        <source>Enter the addresses that may connect on the page Profile (rotctld.allow), or listen on 127.0.0.1</source>
        <translation>Indique na página Perfil os endereços que podem conectar-se (rotctld.allow), ou escute em 127.0.0.1</translation>
    </message>
    <message>
        <source>Boresight commands nothing and accepts no client</source>
        <translation>O Boresight não comanda nada e não aceita clientes</translation>
    </message>
    <message>
        <source>The position journal is not stored: %1</source>
        <translation>O diário de posição não está guardado: %1</translation>
    </message>
    <message>
        <source>Check the disk, or choose another folder with --state-dir. After a restart the cable wrap may be unknown</source>
        <translation>Verifique o disco, ou escolha outra pasta com --state-dir. Depois de um reinício a volta do cabo pode ser desconhecida</translation>
    </message>
    <message>
        <source>The log is not stored: %1</source>
        <translation>O registo não está guardado: %1</translation>
    </message>
    <message>
        <source>Nothing to do. Tracking resumes when the target comes inside the limits</source>
        <translation>Nada a fazer. O seguimento continua quando o alvo voltar a estar dentro dos limites</translation>
    </message>
    <message>
        <source>The azimuth reaches its cable end (%1) at %2</source>
        <translation>O azimute chega ao fim do cabo (%1) às %2</translation>
    </message>
    <message>
        <source>Boresight will unwrap the cable by 360° there. The target is lost for %3</source>
        <translation>O Boresight desenrola aí o cabo 360°. O alvo perde-se durante %3</translation>
    </message>
    <message>
        <source>reaches its cable end (%1) at %2</source>
        <translation>chega ao fim do cabo (%1) às %2</translation>
    </message>
    <message>
        <source>Boresight will hold there until the mount can reach the target again</source>
        <translation>O Boresight segura aí até a montagem poder alcançar de novo o alvo</translation>
    </message>
    <message>
        <source>Widen the limits if the cable allows it, or track another target</source>
        <translation>Alargue os limites se o cabo o permitir, ou siga outro alvo</translation>
    </message>
    <message>
        <source>Boresight looks for the board every 2 s</source>
        <translation>O Boresight procura a placa a cada 2 s</translation>
    </message>
    <message>
        <source>Boresight does not use this board</source>
        <translation>O Boresight não usa esta placa</translation>
    </message>
    <message>
        <source>Boresight treats the cable wrap of this axis as unknown</source>
        <translation>O Boresight trata a volta do cabo deste eixo como desconhecida</translation>
    </message>
    <message>
        <source>Boresight reads the settings again every 2 s</source>
        <translation>O Boresight lê os parâmetros de novo a cada 2 s</translation>
    </message>
    <message>
        <source>The mount may still move</source>
        <translation>A montagem ainda pode mover-se</translation>
    </message>
    <message>
        <source>The station has sent no status for %1</source>
        <translation>A estação não envia estado há %1</translation>
    </message>
    <message>
        <source>The window sent STOP, but the status does not show it</source>
        <translation>A janela enviou STOP, mas o estado não o mostra</translation>
    </message>
    <message>
        <source>STOP is latched</source>
        <translation>STOP está retido</translation>
    </message>
    <message>
        <source>Boresight holds the mount and refuses every motion</source>
        <translation>O Boresight segura a montagem e recusa qualquer movimento</translation>
    </message>
    <message>
        <source>Press Reset stop when the mount may move again</source>
        <translation>Prima Repor STOP quando a montagem puder voltar a mover-se</translation>
    </message>
    <message>
        <source>there in %1</source>
        <translation>lá dentro de %1</translation>
    </message>
    <message>
        <source>takes control from %1, and Boresight refuses motion commands of clients</source>
        <translation>tira o controlo a %1, e o Boresight recusa comandos de movimento de clientes</translation>
    </message>
    <message>
        <source>Likely cause: %1. %2</source>
        <translation>Causa provável: %1. %2</translation>
    </message>
    <message>
        <source>%1. Then press Re-arm</source>
        <translation>%1. Depois prima Rearmar</translation>
    </message>
    <message>
        <source>Check the supply, the CAN cable and the adapter. Then press Re-arm</source>
        <translation>Verifique a alimentação, o cabo CAN e o adaptador. Depois prima Rearmar</translation>
    </message>
    <message>
        <source>Check the supply, the CAN cable, the adapter and the id of the drive. The page Drives lists the drives</source>
        <translation>Verifique a alimentação, o cabo CAN, o adaptador e o id do acionamento. A página Acionamentos mostra a lista</translation>
    </message>
    <message>
        <source>switches the %1 off, so nothing holds its axis</source>
        <translation>desliga o %1, por isso nada segura o seu eixo</translation>
    </message>
    <message>
        <source>azimuth axis %1 below limit %2</source>
        <translation>eixo de azimute %1 abaixo do limite %2</translation>
    </message>
    <message>
        <source>azimuth axis %1 above limit %2</source>
        <translation>eixo de azimute %1 acima do limite %2</translation>
    </message>
    <message>
        <source>azimuth %1 outside travel (axis %2…%3)</source>
        <translation>azimute %1 fora do curso (eixo %2…%3)</translation>
    </message>
    <message>
        <source>azimuth %1 outside limits (axis %2…%3)</source>
        <translation>azimute %1 fora dos limites (eixo %2…%3)</translation>
    </message>
    <message>
        <source>azimuth axis %1 outside limits %2…%3</source>
        <translation>eixo de azimute %1 fora dos limites %2…%3</translation>
    </message>
    <message>
        <source>the azimuth axis limit %1</source>
        <translation>limite do eixo de azimute %1</translation>
    </message>
    <message>
        <source>Broker</source>
        <translation>Broker</translation>
    </message>
    <message>
        <source>Name or address of the MQTT broker, for the sensor and for publishing.</source>
        <translation>Nome ou endereço do broker MQTT, para o sensor e para publicar.</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Porta</translation>
    </message>
    <message>
        <source>Port of the broker: usually 1883, with TLS 8883.</source>
        <translation>Porta do broker: normalmente 1883, com TLS 8883.</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilizador</translation>
    </message>
    <message>
        <source>User name at the broker. Empty: none.</source>
        <translation>Nome de utilizador no broker. Vazio: nenhum.</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Palavra-passe</translation>
    </message>
    <message>
        <source>Password at the broker. This file contains it as plain text, so only its owner may read the file. No log contains it.</source>
        <translation>Palavra-passe no broker. Este ficheiro contém-na em texto simples, por isso só o dono o pode ler. Nenhum registo a contém.</translation>
    </message>
    <message>
        <source>TLS</source>
        <translation>TLS</translation>
    </message>
    <message>
        <source>Encrypt the connection, and accept only a broker with a valid certificate.</source>
        <translation>Cifrar a ligação, e aceitar só um broker com certificado válido.</translation>
    </message>
    <message>
        <source>Certificate authority</source>
        <translation>Autoridade de certificação</translation>
    </message>
    <message>
        <source>With TLS: PEM file of the authority that signed the broker&apos;s certificate. Empty: the authorities that this computer trusts.</source>
        <translation>Com TLS: ficheiro PEM da autoridade que assinou o certificado do broker. Vazio: as autoridades em que este computador confia.</translation>
    </message>
    <message>
        <source>Client id</source>
        <translation>Id do cliente</translation>
    </message>
    <message>
        <source>Name of this program at the broker. A broker disconnects the first of two clients with one name. Empty: a new name at every start.</source>
        <translation>Nome deste programa no broker. Um broker desliga o primeiro de dois clientes com o mesmo nome. Vazio: um nome novo em cada arranque.</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Publicar</translation>
    </message>
    <message>
        <source>Whether Boresight sends the position and the state of the mount to the broker each second.</source>
        <translation>Se o Boresight envia a posição e o estado da montagem ao broker a cada segundo.</translation>
    </message>
    <message>
        <source>Topic prefix</source>
        <translation>Prefixo dos tópicos</translation>
    </message>
    <message>
        <source>is the same as azimuth.id. Each controller needs its own id.</source>
        <translation>é igual a azimuth.id. Cada controlador precisa do seu id.</translation>
    </message>
    <message>
        <source>North offset</source>
        <translation>Desvio do norte</translation>
    </message>
    <message>
        <source>True azimuth of the beam when the azimuth axis shows 0°. The North panel finds it.</source>
        <translation>Azimute verdadeiro do feixe quando o eixo de azimute mostra 0°. O painel Norte encontra-o.</translation>
    </message>
    <message>
        <source>Elevation offset</source>
        <translation>Desvio de elevação</translation>
    </message>
    <message>
        <source>True elevation of the beam when the elevation axis shows 0°.</source>
        <translation>Elevação verdadeira do feixe quando o eixo de elevação mostra 0°.</translation>
    </message>
    <message>
        <source>Tilt to the north</source>
        <translation>Inclinação para norte</translation>
    </message>
    <message>
        <source>How far the azimuth axis leans to the north. A negative value leans to the south.</source>
        <translation>Quanto o eixo de azimute se inclina para norte. Um valor negativo inclina-se para sul.</translation>
    </message>
    <message>
        <source>Tilt to the east</source>
        <translation>Inclinação para leste</translation>
    </message>
    <message>
        <source>How far the azimuth axis leans to the east. A negative value leans to the west.</source>
        <translation>Quanto o eixo de azimute se inclina para leste. Um valor negativo inclina-se para oeste.</translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation>Colimação</translation>
    </message>
    <message>
        <source>Sag</source>
        <translation>Flexão</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origem</translation>
    </message>
    <message>
        <source>Whether a receiver reports the received power for the cross scan, one number in dB per line. &quot;udp&quot; listens for it, &quot;tcp&quot; connects to it.</source>
        <translation>Se um recetor comunica a potência recebida para o varrimento em cruz, um número em dB por linha. &quot;udp&quot; escuta, &quot;tcp&quot; conecta-se a ele.</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Anfitrião</translation>
    </message>
    <message>
        <source>missing: %1. The keys of this table are only valid together.</source>
        <translation>falta: %1. As chaves desta tabela só valem juntas.</translation>
    </message>
    <message>
        <source>%1 has several profiles, and %2 names none of them. Choose one with --profile.</source>
        <translation>%1 tem vários perfis, e %2 não indica nenhum deles. Escolha um com --profile.</translation>
    </message>
    <message>
        <source>%1: The folder cannot be created.</source>
        <translation>%1: Não é possível criar a pasta.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the mount in use. Switch to another mount first.</source>
        <translation>&quot;%1&quot; é a montagem em uso. Mude primeiro para outra montagem.</translation>
    </message>
    <message>
        <source>A mount &quot;%1&quot; already exists (%2). Give this mount another name.</source>
        <translation>Já existe uma montagem &quot;%1&quot; (%2). Dê outro nome a esta montagem.</translation>
    </message>
    <message>
        <source>The limits %1…%2 do not overlap the travel %3…%4.</source>
        <translation>Os limites %1…%2 não se sobrepõem ao curso %3…%4.</translation>
    </message>
    <message>
        <source>Azimuth %1 does not follow %2. The azimuths must ascend, each once.</source>
        <translation>O azimute %1 não vem depois de %2. Os azimutes têm de ser crescentes, cada um uma vez.</translation>
    </message>
    <message>
        <source>The name &quot;%1&quot; is used twice.</source>
        <translation>O nome &quot;%1&quot; é usado duas vezes.</translation>
    </message>
    <message>
        <source>is the same as azimuth_from_deg, so the keep-out has no width</source>
        <translation>é igual a azimuth_from_deg, por isso a zona proibida não tem largura</translation>
    </message>
    <message>
        <source>The site is not set. Boresight cannot compute the position of the Sun without it.</source>
        <translation>O local não está definido. Sem ele o Boresight não pode calcular a posição do Sol.</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimute</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevação</translation>
    </message>
    <message>
        <source>Lowest elevation of the beam at this azimuth.</source>
        <translation>Menor elevação do feixe neste azimute.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Name of the keep-out.</source>
        <translation>Nome da zona proibida.</translation>
    </message>
    <message>
        <source>Azimuth from</source>
        <translation>Azimute desde</translation>
    </message>
    <message>
        <source>Azimuth to</source>
        <translation>Azimute até</translation>
    </message>
    <message>
        <source>Elevation from</source>
        <translation>Elevação desde</translation>
    </message>
    <message>
        <source>Elevation to</source>
        <translation>Elevação até</translation>
    </message>
    <message>
        <source>Name of the preset.</source>
        <translation>Nome da predefinição.</translation>
    </message>
    <message>
        <source>Elevation. A value above 90 points over the top.</source>
        <translation>Elevação. Um valor acima de 90 aponta para além do zénite.</translation>
    </message>
    <message>
        <source>Lowest azimuth</source>
        <translation>Menor azimute</translation>
    </message>
    <message>
        <source>Lowest azimuth in operation, as an axis angle. The travel limits the axis, too.</source>
        <translation>Menor azimute em operação, como ângulo do eixo. O curso também limita o eixo.</translation>
    </message>
    <message>
        <source>Highest azimuth</source>
        <translation>Maior azimute</translation>
    </message>
    <message>
        <source>Highest azimuth in operation, as an axis angle.</source>
        <translation>Maior azimute em operação, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Lowest elevation</source>
        <translation>Menor elevação</translation>
    </message>
    <message>
        <source>Lowest elevation in operation, as an axis angle.</source>
        <translation>Menor elevação em operação, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Highest elevation</source>
        <translation>Maior elevação</translation>
    </message>
    <message>
        <source>Highest elevation in operation, as an axis angle.</source>
        <translation>Maior elevação em operação, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Latitude of the mount. North is positive.</source>
        <translation>Latitude da montagem. O norte é positivo.</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>Longitude of the mount. East is positive.</source>
        <translation>Longitude da montagem. O leste é positivo.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altitude</translation>
    </message>
    <message>
        <source>Height of the mount above sea level.</source>
        <translation>Altitude da montagem acima do nível do mar.</translation>
    </message>
    <message>
        <source>Folder of Gpredict</source>
        <translation>Pasta do Gpredict</translation>
    </message>
    <message>
        <source>Folder with the stations and satellite data of Gpredict. Empty: the folder that Gpredict uses for this user.</source>
        <translation>Pasta com as estações e os dados de satélites do Gpredict. Vazio: a pasta que o Gpredict usa para este utilizador.</translation>
    </message>
    <message>
        <source>Keep away from the Sun</source>
        <translation>Manter longe do Sol</translation>
    </message>
    <message>
        <source>Whether the beam stays away from the Sun, whatever moves the mount. This needs the site.</source>
        <translation>Se o feixe fica longe do Sol, seja o que for que mova a montagem. Isto precisa do local.</translation>
    </message>
    <message>
        <source>Clock for the Sun</source>
        <translation>Relógio para o Sol</translation>
    </message>
    <message>
        <source>Distance from the Sun</source>
        <translation>Distância ao Sol</translation>
    </message>
    <message>
        <source>The beam stays this far from the middle of the Sun.</source>
        <translation>O feixe fica a esta distância do meio do Sol.</translation>
    </message>
    <message>
        <source>Whether an independent orientation sensor is on the antenna, and how Boresight reads it. &quot;simulated&quot; is the sensor of the simulated mount.</source>
        <translation>Se há um sensor de orientação independente na antena, e como o Boresight o lê. &quot;simulated&quot; é o sensor da montagem simulada.</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Porta série</translation>
    </message>
    <message>
        <source>Device of the serial port of the sensor. A name in /dev/serial/by-id stays the same in every socket.</source>
        <translation>Dispositivo da porta série do sensor. Um nome em /dev/serial/by-id é o mesmo em qualquer tomada.</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Velocidade (baud)</translation>
    </message>
    <message>
        <source>Speed of the serial port of the sensor.</source>
        <translation>Velocidade da porta série do sensor.</translation>
    </message>
    <message>
        <source>Topic of the orientation</source>
        <translation>Tópico da orientação</translation>
    </message>
    <message>
        <source>MQTT topic of the azimuth and the elevation of the sensor.</source>
        <translation>Tópico MQTT do azimute e da elevação do sensor.</translation>
    </message>
    <message>
        <source>Topic of the status</source>
        <translation>Tópico do estado</translation>
    </message>
    <message>
        <source>MQTT topic of the temperature and the firmware of the sensor.</source>
        <translation>Tópico MQTT da temperatura e do firmware do sensor.</translation>
    </message>
    <message>
        <source>Topic of the calibration</source>
        <translation>Tópico da calibração</translation>
    </message>
    <message>
        <source>Azimuth direction</source>
        <translation>Sentido do azimute</translation>
    </message>
    <message>
        <source>The direction in which the sensor&apos;s azimuth grows, seen from above. It depends on the mounting. Turn the mount and watch the value.</source>
        <translation>O sentido em que o azimute do sensor cresce, visto de cima. Depende da instalação do sensor. Gire a montagem e observe o valor.</translation>
    </message>
    <message>
        <source>Azimuth offset</source>
        <translation>Desvio do azimute</translation>
    </message>
    <message>
        <source>True azimuth of the beam when the sensor points north.</source>
        <translation>Azimute verdadeiro do feixe quando o sensor aponta para norte.</translation>
    </message>
    <message>
        <source>Elevation of the beam when the sensor reports 0°.</source>
        <translation>Elevação do feixe quando o sensor indica 0°.</translation>
    </message>
    <message>
        <source>Uncertainty of north</source>
        <translation>Incerteza do norte</translation>
    </message>
    <message>
        <source>Elevation of the swing</source>
        <translation>Elevação do giro</translation>
    </message>
    <message>
        <source>Unreliable headings</source>
        <translation>Rumos não fiáveis</translation>
    </message>
    <message>
        <source>Compass error: sine</source>
        <translation>Erro da bússola: seno</translation>
    </message>
    <message>
        <source>Error of the compass, as a swing measures it: the part that follows the sine of the true heading.</source>
        <translation>Erro da bússola, medido por um giro: a parte que segue o seno do rumo verdadeiro.</translation>
    </message>
    <message>
        <source>Compass error: cosine</source>
        <translation>Erro da bússola: cosseno</translation>
    </message>
    <message>
        <source>The part that follows the cosine of the true heading.</source>
        <translation>A parte que segue o cosseno do rumo verdadeiro.</translation>
    </message>
    <message>
        <source>Compass error: sine of twice</source>
        <translation>Erro da bússola: seno do dobro</translation>
    </message>
    <message>
        <source>The part that follows the sine of twice the true heading.</source>
        <translation>A parte que segue o seno do dobro do rumo verdadeiro.</translation>
    </message>
    <message>
        <source>Compass error: cosine of twice</source>
        <translation>Erro da bússola: cosseno do dobro</translation>
    </message>
    <message>
        <source>The part that follows the cosine of twice the true heading.</source>
        <translation>A parte que segue o cosseno do dobro do rumo verdadeiro.</translation>
    </message>
    <message>
        <source>Declination applied by</source>
        <translation>Declinação aplicada por</translation>
    </message>
    <message>
        <source>Where the magnetic declination is applied: in the sensor alone, in Boresight alone (for the site, in place of the sensor&apos;s value), or nowhere.</source>
        <translation>Onde se aplica a declinação magnética: só no sensor, só no Boresight (para o local, em vez do valor do sensor), ou em lado nenhum.</translation>
    </message>
    <message>
        <source>Declination in the firmware</source>
        <translation>Declinação no firmware</translation>
    </message>
    <message>
        <source>The sensor&apos;s firmware adds this angle to its azimuth: 5.07° as delivered, for Berlin.</source>
        <translation>O firmware do sensor soma este ângulo ao seu azimute: 5.07° de fábrica, para Berlim.</translation>
    </message>
    <message>
        <source>Declination of the site</source>
        <translation>Declinação do local</translation>
    </message>
    <message>
        <source>Magnetic declination of the site, east positive. It is used while the file below is empty.</source>
        <translation>Declinação magnética do local, positiva para leste. Usa-se enquanto o ficheiro abaixo estiver vazio.</translation>
    </message>
    <message>
        <source>Magnetic model</source>
        <translation>Modelo magnético</translation>
    </message>
    <message>
        <source>Coefficients of the World Magnetic Model (.COF). Boresight computes the declination of the site from them.</source>
        <translation>Coeficientes do World Magnetic Model (.COF). O Boresight calcula com eles a declinação do local.</translation>
    </message>
    <message>
        <source>Lost after</source>
        <translation>Perdido após</translation>
    </message>
    <message>
        <source>The sensor counts as lost after this time without a value. Its last values are then not used.</source>
        <translation>O sensor conta como perdido após este tempo sem um valor. Os seus últimos valores deixam então de ser usados.</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latência</translation>
    </message>
    <message>
        <source>Age of the sensor&apos;s azimuth when Boresight receives it. The age counts from the middle of the firmware&apos;s averaging time.</source>
        <translation>Idade do azimute do sensor quando o Boresight o recebe. A idade conta desde o meio do tempo de média do firmware.</translation>
    </message>
    <message>
        <source>Averaging time</source>
        <translation>Tempo de média</translation>
    </message>
    <message>
        <source>Disagreement: warn</source>
        <translation>Discordância: avisar</translation>
    </message>
    <message>
        <source>Warn when sensor and axes differ by this angle for the time below.</source>
        <translation>Avisar quando sensor e eixos diferem deste ângulo durante o tempo abaixo.</translation>
    </message>
    <message>
        <source>Disagreement: time</source>
        <translation>Discordância: tempo</translation>
    </message>
    <message>
        <source>Current limit, standing</source>
        <translation>Limite de corrente, parado</translation>
    </message>
    <message>
        <source>North is not averaged while a motor current is higher. The field of the motor disturbs the compass.</source>
        <translation>Não se faz a média do norte enquanto a corrente de um motor for mais alta. O campo do motor perturba a bússola.</translation>
    </message>
    <message>
        <source>Current limit, swinging</source>
        <translation>Limite de corrente, no giro</translation>
    </message>
    <message>
        <source>A compass swing ignores readings taken at a higher motor current. Turning needs some current.</source>
        <translation>Um giro da bússola ignora leituras tomadas com uma corrente do motor mais alta. Girar precisa de alguma corrente.</translation>
    </message>
    <message>
        <source>Name of the mount</source>
        <translation>Nome da montagem</translation>
    </message>
    <message>
        <source>The name of this mount for clients and in the window. Its position journal is kept under this name.</source>
        <translation>O nome desta montagem para os clientes e na janela. O seu diário de posição é guardado com este nome.</translation>
    </message>
    <message>
        <source>Beam width</source>
        <translation>Largura do feixe</translation>
    </message>
    <message>
        <source>Half-power beam width of the antenna. The sky shows it as a circle.</source>
        <translation>Largura do feixe da antena a meia potência. O céu mostra-a como um círculo.</translation>
    </message>
    <message>
        <source>Directions confirmed</source>
        <translation>Sentidos confirmados</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Barramento</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Driver</translation>
    </message>
    <message>
        <source>CAN id</source>
        <translation>Id CAN</translation>
    </message>
    <message>
        <source>CAN id of the moteus controller of this axis.</source>
        <translation>Id CAN do controlador moteus deste eixo.</translation>
    </message>
    <message>
        <source>Motor direction</source>
        <translation>Sentido do motor</translation>
    </message>
    <message>
        <source>1, or -1 if the motor counts down while the axis angle grows. 0 is refused.</source>
        <translation>1, ou -1 se o motor conta para baixo enquanto o ângulo do eixo cresce. 0 é recusado.</translation>
    </message>
    <message>
        <source>Axis zero offset</source>
        <translation>Desvio do zero do eixo</translation>
    </message>
    <message>
        <source>Gear ratio</source>
        <translation>Redução</translation>
    </message>
    <message>
        <source>Turns of the motor for one turn of the axis.</source>
        <translation>Voltas do motor para uma volta do eixo.</translation>
    </message>
    <message>
        <source>Gear ratio applied in</source>
        <translation>Redução aplicada em</translation>
    </message>
    <message>
        <source>Where the gear ratio is applied. With &quot;drive&quot; the controller already counts turns of the axis.</source>
        <translation>Onde se aplica a redução. Com &quot;drive&quot; o controlador já conta voltas do eixo.</translation>
    </message>
    <message>
        <source>Travel from</source>
        <translation>Curso de</translation>
    </message>
    <message>
        <source>Lower end of the permitted travel, as an axis angle.</source>
        <translation>Fim inferior do curso permitido, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Travel to</source>
        <translation>Curso até</translation>
    </message>
    <message>
        <source>Upper end of the permitted travel, as an axis angle: 370° is not 10°.</source>
        <translation>Fim superior do curso permitido, como ângulo do eixo: 370° não é 10°.</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Velocidade máxima</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleração</translation>
    </message>
    <message>
        <source>Largest change of speed, also in a stop.</source>
        <translation>Maior variação da velocidade, também numa paragem.</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Jerk</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>Torque máximo</translation>
    </message>
    <message>
        <source>Position after power-up</source>
        <translation>Posição após ligar</translation>
    </message>
    <message>
        <source>&quot;trusted&quot; if the position after power-up is always right: an encoder on the axis and a travel below one turn. Otherwise the axis points only while the drive reports a referenced output.</source>
        <translation>&quot;trusted&quot; se a posição após ligar está sempre certa: um encoder no eixo e um curso inferior a uma volta. Senão, o eixo só aponta enquanto o acionamento comunicar uma saída referenciada.</translation>
    </message>
    <message>
        <source>If commands stop</source>
        <translation>Se os comandos cessarem</translation>
    </message>
    <message>
        <source>Set-points per second</source>
        <translation>Referências por segundo</translation>
    </message>
    <message>
        <source>How often each drive gets a new set-point.</source>
        <translation>Quantas vezes cada acionamento recebe uma nova referência.</translation>
    </message>
    <message>
        <source>Drive watchdog</source>
        <translation>Watchdog do acionamento</translation>
    </message>
    <message>
        <source>After a stall</source>
        <translation>Após bloqueio do PC</translation>
    </message>
    <message>
        <source>At program end</source>
        <translation>No fim do programa</translation>
    </message>
    <message>
        <source>Margin of the drives&apos; own limits</source>
        <translation>Margem dos limites dos acionamentos</translation>
    </message>
    <message>
        <source>The position limits in the drives lie this far beyond the travel. They hold without this program.</source>
        <translation>Os limites de posição nos acionamentos ficam a esta distância além do curso. Valem sem este programa.</translation>
    </message>
    <message>
        <source>Park azimuth</source>
        <translation>Estacionar: azimute</translation>
    </message>
    <message>
        <source>Azimuth of the park position, as an axis angle.</source>
        <translation>Azimute da posição de estacionamento, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Park elevation</source>
        <translation>Estacionar: elevação</translation>
    </message>
    <message>
        <source>Elevation of the park position, as an axis angle.</source>
        <translation>Elevação da posição de estacionamento, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Slow jog rate</source>
        <translation>Vel. manual lenta</translation>
    </message>
    <message>
        <source>The lowest jog rate of the slider.</source>
        <translation>A menor velocidade manual do cursor.</translation>
    </message>
    <message>
        <source>Normal jog rate</source>
        <translation>Vel. manual normal</translation>
    </message>
    <message>
        <source>The jog rate at the start.</source>
        <translation>A velocidade manual no início.</translation>
    </message>
    <message>
        <source>Fast jog rate</source>
        <translation>Vel. manual rápida</translation>
    </message>
    <message>
        <source>The highest jog rate of the slider, and the rate of Shift + arrow.</source>
        <translation>A maior velocidade manual do cursor, e a velocidade de Shift + seta.</translation>
    </message>
    <message>
        <source>Jog rate while the wrap is unknown</source>
        <translation>Vel. manual com volta desconhecida</translation>
    </message>
    <message>
        <source>The highest jog rate while the cable wrap of an axis is unknown.</source>
        <translation>A maior velocidade manual enquanto a volta do cabo de um eixo for desconhecida.</translation>
    </message>
    <message>
        <source>Listen on</source>
        <translation>Escutar em</translation>
    </message>
    <message>
        <source>HOST:PORT for rotctld clients. Port 0 takes any free port. 127.0.0.1 admits this computer only.</source>
        <translation>HOST:PORT para clientes rotctld. A porta 0 usa qualquer porta livre. 127.0.0.1 só admite este computador.</translation>
    </message>
    <message>
        <source>Allowed addresses</source>
        <translation>Endereços permitidos</translation>
    </message>
    <message>
        <source>Addresses and networks that may connect, for example &quot;192.168.1.7&quot; or &quot;10.0.0.0/8&quot;. Empty: every client that reaches the port.</source>
        <translation>Endereços e redes que podem ligar-se, por exemplo &quot;192.168.1.7&quot; ou &quot;10.0.0.0/8&quot;. Vazio: qualquer cliente que chegue à porta.</translation>
    </message>
    <message>
        <source>Control goes to</source>
        <translation>Controlo vai para</translation>
    </message>
    <message>
        <source>Locked to</source>
        <translation>Reservado a</translation>
    </message>
    <message>
        <source>Address of the only client that may move the mount while control is &quot;locked&quot;.</source>
        <translation>Endereço do único cliente que pode mover a montagem enquanto o controlo está reservado (&quot;locked&quot;).</translation>
    </message>
    <message>
        <source>Target outside the limits</source>
        <translation>Alvo fora dos limites</translation>
    </message>
    <message>
        <source>Go to the nearest permitted point, or refuse the command.</source>
        <translation>Ir para o ponto permitido mais próximo, ou recusar o comando.</translation>
    </message>
    <message>
        <source>Azimuth for clients</source>
        <translation>Azimute para clientes</translation>
    </message>
    <message>
        <source>The form of the reported azimuth. &quot;continuous&quot; counts the turns of the axis: 370° is not 10°.</source>
        <translation>A forma do azimute comunicado. &quot;continuous&quot; conta as voltas do eixo: 370° não é 10°.</translation>
    </message>
    <message>
        <source>Form of the state dump</source>
        <translation>Forma do dump de estado</translation>
    </message>
    <message>
        <source>Most clients</source>
        <translation>Máximo de clientes</translation>
    </message>
    <message>
        <source>The largest number of connections at the same time.</source>
        <translation>O maior número de ligações ao mesmo tempo.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not one of %2</source>
        <translation>&quot;%1&quot; não é um de %2</translation>
    </message>
    <message>
        <source>Following error: warn</source>
        <translation>Erro de seguimento: avisar</translation>
    </message>
    <message>
        <source>Warn when set-point and axis differ by this angle for the time below.</source>
        <translation>Avisar quando referência e eixo diferem deste ângulo durante o tempo abaixo.</translation>
    </message>
    <message>
        <source>Following error: stop</source>
        <translation>Erro de seguimento: parar</translation>
    </message>
    <message>
        <source>Stop the mount when set-point and axis differ by this angle for the time below.</source>
        <translation>Parar a montagem quando referência e eixo diferem deste ângulo durante o tempo abaixo.</translation>
    </message>
    <message>
        <source>Following error: time</source>
        <translation>Erro de seguimento: tempo</translation>
    </message>
    <message>
        <source>Blocked axis: time</source>
        <translation>Eixo bloqueado: tempo</translation>
    </message>
    <message>
        <source>Stop the mount when an axis has not moved for this time although it is commanded to move.</source>
        <translation>Parar a montagem quando um eixo não se moveu durante este tempo, embora tenha ordem para se mover.</translation>
    </message>
    <message>
        <source>Motion without a command</source>
        <translation>Movimento sem comando</translation>
    </message>
    <message>
        <source>Stop the mount when an axis that should stand still has moved by this angle. Warn only while its drive is off.</source>
        <translation>Parar a montagem quando um eixo que devia estar parado se moveu deste ângulo. Só avisar enquanto o seu acionamento estiver desligado.</translation>
    </message>
    <message>
        <source>Jump of the position</source>
        <translation>Salto da posição</translation>
    </message>
    <message>
        <source>Stop the mount when an angle changes between two replies by this much more than the axis can turn.</source>
        <translation>Parar a montagem quando um ângulo muda entre duas respostas este tanto mais do que o eixo pode girar.</translation>
    </message>
    <message>
        <source>Beyond the travel: warn</source>
        <translation>Além do curso: avisar</translation>
    </message>
    <message>
        <source>Warn when an axis is this far beyond its travel.</source>
        <translation>Avisar quando um eixo está a esta distância além do seu curso.</translation>
    </message>
    <message>
        <source>Beyond the travel: stop</source>
        <translation>Além do curso: parar</translation>
    </message>
    <message>
        <source>Stop the mount when an axis is this far beyond its travel and moves farther out.</source>
        <translation>Parar a montagem quando um eixo está a esta distância além do seu curso e se afasta mais.</translation>
    </message>
    <message>
        <source>High torque: warn</source>
        <translation>Torque alto: avisar</translation>
    </message>
    <message>
        <source>Warn when an axis needs this share of its largest torque for 2 s.</source>
        <translation>Avisar quando um eixo precisa desta parte do seu torque máximo durante 2 s.</translation>
    </message>
    <message>
        <source>Torque while standing: warn</source>
        <translation>Torque parado: avisar</translation>
    </message>
    <message>
        <source>Warn when an axis that stands still needs this share of its largest torque for 2 s. Set it a little above the share that weight and friction need.</source>
        <translation>Avisar quando um eixo parado precisa desta parte do seu torque máximo durante 2 s. Defina-a um pouco acima da parte de que o peso e o atrito precisam.</translation>
    </message>
    <message>
        <source>Torque while the wrap is unknown</source>
        <translation>Torque com volta desconhecida</translation>
    </message>
    <message>
        <source>Late reply: warn</source>
        <translation>Resposta tardia: avisar</translation>
    </message>
    <message>
        <source>Low supply: warn</source>
        <translation>Alimentação baixa: avisar</translation>
    </message>
    <message>
        <source>Warn below this supply voltage.</source>
        <translation>Avisar abaixo desta tensão de alimentação.</translation>
    </message>
    <message>
        <source>Low supply: stop</source>
        <translation>Alimentação baixa: parar</translation>
    </message>
    <message>
        <source>Stop the mount below this supply voltage, while the drives still can.</source>
        <translation>Parar a montagem abaixo desta tensão de alimentação, enquanto os acionamentos ainda podem.</translation>
    </message>
    <message>
        <source>High supply: warn</source>
        <translation>Alimentação alta: avisar</translation>
    </message>
    <message>
        <source>Warn above this supply voltage. A stop would brake and raise the voltage further.</source>
        <translation>Avisar acima desta tensão de alimentação. Uma paragem travaria e subiria ainda mais a tensão.</translation>
    </message>
    <message>
        <source>Drive board: warn</source>
        <translation>Placa: avisar</translation>
    </message>
    <message>
        <source>Warn above this drive-board temperature.</source>
        <translation>Avisar acima desta temperatura da placa do acionamento.</translation>
    </message>
    <message>
        <source>Drive board: limit</source>
        <translation>Placa: limite</translation>
    </message>
    <message>
        <source>Temperature at which the drive reports fault 38 (servo.fault_temperature). Trends are computed up to it.</source>
        <translation>Temperatura a que o acionamento comunica a falha 38 (servo.fault_temperature). As tendências calculam-se até ela.</translation>
    </message>
    <message>
        <source>Motor: warn</source>
        <translation>Motor: avisar</translation>
    </message>
    <message>
        <source>Warn above this temperature of a motor with a sensor.</source>
        <translation>Avisar acima desta temperatura de um motor com sensor.</translation>
    </message>
    <message>
        <source>Trend: look ahead</source>
        <translation>Tendência: antecipação</translation>
    </message>
    <message>
        <source>Warn when supply or temperature will reach the limit within this time if they change as in the last minute.</source>
        <translation>Avisar quando a alimentação ou a temperatura chegarão ao limite dentro deste tempo, se mudarem como no último minuto.</translation>
    </message>
    <message>
        <source>Re-arm after overheating</source>
        <translation>Rearmar após sobreaquecimento</translation>
    </message>
    <message>
        <source>Re-arm without a person when an overheated drive (fault 38) has cooled down by 5 °C.</source>
        <translation>Rearmar sem uma pessoa quando um acionamento sobreaquecido (falha 38) arrefeceu 5 °C.</translation>
    </message>
    <message>
        <source>Re-arm after a supply fault</source>
        <translation>Rearmar após falha de alimentação</translation>
    </message>
    <message>
        <source>Re-arm without a person when the supply voltage (faults 34, 40) is back in its range.</source>
        <translation>Rearmar sem uma pessoa quando a tensão de alimentação (falhas 34, 40) volta à sua gama.</translation>
    </message>
    <message>
        <source>Re-arm after silence</source>
        <translation>Rearmar após silêncio</translation>
    </message>
    <message>
        <source>Re-arm without a person when silent or timed-out drives reply again.</source>
        <translation>Rearmar sem uma pessoa quando acionamentos calados ou com tempo esgotado voltam a responder.</translation>
    </message>
    <message>
        <source>Time between attempts</source>
        <translation>Tempo entre tentativas</translation>
    </message>
    <message>
        <source>Time from a fault, or from the last attempt, to the next attempt to re-arm.</source>
        <translation>Tempo desde uma falha, ou desde a última tentativa, até à próxima tentativa de rearmar.</translation>
    </message>
    <message>
        <source>go to azimuth %1</source>
        <translation>ir ao azimute %1</translation>
    </message>
    <message>
        <source>go to elevation %1</source>
        <translation>ir à elevação %1</translation>
    </message>
    <message>
        <source>unwrap the cable, azimuth axis to %1</source>
        <translation>desenrolar o cabo, eixo de azimute até %1</translation>
    </message>
    <message>
        <source>named by the command line or the profile</source>
        <translation>da linha de comandos ou do perfil</translation>
    </message>
    <message>
        <source>%1 was %2 away from its set-point for %3 (set-point %4, axis %5)</source>
        <translation>%1 esteve a %2 da sua referência durante %3 (referência %4, eixo %5)</translation>
    </message>
    <message>
        <source>the supply of %1 fell to %2 V, below %3 V</source>
        <translation>a alimentação (%1) caiu para %2 V, abaixo de %3 V</translation>
    </message>
    <message>
        <source>the supply of %1 rose to %2 V, above %3 V</source>
        <translation>a alimentação (%1) subiu para %2 V, acima de %3 V</translation>
    </message>
    <message>
        <source>%1 reached %2 °C and switches off at %3 °C</source>
        <translation>%1 chegou a %2 °C e desliga-se a %3 °C</translation>
    </message>
    <message>
        <source>%1 reached %2 °C</source>
        <translation>%1 chegou a %2 °C</translation>
    </message>
    <message>
        <source>The drive check has not run yet.</source>
        <translation>A verificação dos acionamentos ainda não foi feita.</translation>
    </message>
    <message>
        <source>The drive check is running. Wait some seconds.</source>
        <translation>A verificação dos acionamentos está em curso. Espere alguns segundos.</translation>
    </message>
    <message>
        <source>%1. Nearest allowed: %2.</source>
        <translation>%1. Mais próximo permitido: %2.</translation>
    </message>
    <message>
        <source>%1 lies in keep-out &quot;%2&quot;</source>
        <translation>%1 fica na zona proibida &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1 lies below the horizon (%2)</source>
        <translation>%1 fica abaixo do horizonte (%2)</translation>
    </message>
    <message>
        <source>Arrival of the axes</source>
        <translation>Chegada dos eixos</translation>
    </message>
    <message>
        <source>How the axes arrive at the end of a slew. &quot;separate&quot;: each axis arrives as soon as it can. &quot;together&quot;: the faster axis slows down so that both arrive at the same time.</source>
        <translation>Como os eixos chegam ao fim de uma deslocação. &quot;separate&quot;: cada eixo chega assim que pode. &quot;together&quot;: o eixo mais rápido abranda para que ambos cheguem ao mesmo tempo.</translation>
    </message>
    <message>
        <source>The answer is neither &quot;ok&quot; nor &quot;error&quot;.</source>
        <translation>A resposta não é «ok» nem «error».</translation>
    </message>
    <message>
        <source>No command came within %1 s.</source>
        <translation>Não chegou nenhum comando em %1 s.</translation>
    </message>
    <message>
        <source>The line is longer than %1 bytes.</source>
        <translation>A linha tem mais de %1 bytes.</translation>
    </message>
    <message>
        <source>cannot make the folder %1: %2</source>
        <translation>não é possível criar a pasta %1: %2</translation>
    </message>
    <message>
        <source>another program listens on %1</source>
        <translation>outro programa está à escuta em %1</translation>
    </message>
    <message>
        <source>cannot remove %1</source>
        <translation>não é possível remover %1</translation>
    </message>
    <message>
        <source>XDG_RUNTIME_DIR is not set</source>
        <translation>XDG_RUNTIME_DIR não está definida</translation>
    </message>
    <message>
        <source>Too many programs ask at the same time. Try again.</source>
        <translation>Demasiados programas pedem ao mesmo tempo. Tente de novo.</translation>
    </message>
    <message>
        <source>limit: %1</source>
        <translation>limite: %1</translation>
    </message>
    <message>
        <source>shell</source>
        <translation>linha de comandos</translation>
    </message>
    <message>
        <source>The target has no trim.</source>
        <translation>O alvo não tem correção.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is only simulated. Start Boresight with --simulate.</source>
        <translation>“%1” existe apenas em simulação. Inicie o Boresight com --simulate.</translation>
    </message>
    <message>
        <source>The local socket did not open: %1. Commands of the shell that need it do not reach this station.</source>
        <translation>O socket local não abriu: %1. Os comandos da linha de comandos que precisam dele não chegam a esta estação.</translation>
    </message>
    <message>
        <source>No board answers. Connect the board of the %1.</source>
        <translation>Nenhuma placa responde. Ligue a placa do %1.</translation>
    </message>
    <message>
        <source>More than one board is connected. Leave only the board of the %1 connected.</source>
        <translation>Há mais de uma placa ligada. Deixe ligada só a placa do %1.</translation>
    </message>
    <message>
        <source>This board has the id %1 of the %2 already.</source>
        <translation>Esta placa já tem o id %1 do %2.</translation>
    </message>
    <message>
        <source>the id %1</source>
        <translation>o id %1</translation>
    </message>
    <message>
        <source>writing the gear ratio %1 into the %2 drive</source>
        <translation>a escrever a redução %1 no acionamento de %2</translation>
    </message>
    <message>
        <source>the gear ratio</source>
        <translation>a redução</translation>
    </message>
    <message>
        <source>The drive check has not read this drive yet.</source>
        <translation>A verificação ainda não leu este acionamento.</translation>
    </message>
    <message>
        <source>Read the gains first.</source>
        <translation>Leia primeiro os ganhos.</translation>
    </message>
    <message>
        <source>The %1 is switched off already.</source>
        <translation>O %1 já está desligado.</translation>
    </message>
    <message>
        <source>tuning run</source>
        <translation>medição de afinação</translation>
    </message>
    <message>
        <source>Reading the gains of %1.</source>
        <translation>A ler os ganhos de %1.</translation>
    </message>
    <message>
        <source>The firmware of this drive has no %1.</source>
        <translation>O firmware deste acionamento não tem %1.</translation>
    </message>
    <message>
        <source>Writing %1 of %2.</source>
        <translation>A escrever %1 de %2.</translation>
    </message>
    <message>
        <source>Putting the gains of %1 back.</source>
        <translation>A repor os ganhos de %1.</translation>
    </message>
    <message>
        <source>Storing the gains of %1.</source>
        <translation>A guardar os ganhos de %1.</translation>
    </message>
    <message>
        <source>The %1 drive did not answer: %2. Read its gains again.</source>
        <translation>O acionamento de %1 não respondeu: %2. Leia os ganhos de novo.</translation>
    </message>
    <message>
        <source>The gains were read.</source>
        <translation>Os ganhos foram lidos.</translation>
    </message>
    <message>
        <source>%1 was set to %2 and reads back %3.</source>
        <translation>%1 foi posto em %2 e lê-se %3.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>gain of %1, in force until a power cycle: %2 %3 → %4</source>
        <translation>ganho de %1, em vigor até desligar a alimentação: %2 %3 → %4</translation>
    </message>
    <message>
        <source>Written and read back.</source>
        <translation>Escrito e relido.</translation>
    </message>
    <message>
        <source>The %1 drive did not store its gains: %2.</source>
        <translation>O acionamento de %1 não guardou os ganhos: %2.</translation>
    </message>
    <message>
        <source>the gains of %1 are stored in its drive</source>
        <translation>os ganhos de %1 estão guardados no acionamento</translation>
    </message>
    <message>
        <source>Two boards with the id %1 are still connected. Disconnect one of them. Nothing was changed.</source>
        <translation>Ainda estão ligadas duas placas com o id %1. Desligue uma delas. Nada foi alterado.</translation>
    </message>
    <message>
        <source>%1. Nothing was changed.</source>
        <translation>%1. Nada foi alterado.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Setting %1.</source>
        <translation>A definir %1.</translation>
    </message>
    <message>
        <source>Reading back %1.</source>
        <translation>A reler %1.</translation>
    </message>
    <message>
        <source>Storing %1.</source>
        <translation>A guardar %1.</translation>
    </message>
    <message>
        <source>Nm/turn</source>
        <translation>Nm/volta</translation>
    </message>
    <message>
        <source>Nm/s/turn</source>
        <translation>Nm/s/volta</translation>
    </message>
    <message>
        <source>Nm/(turn/s)</source>
        <translation>Nm/(volta/s)</translation>
    </message>
    <message>
        <source>step of the azimuth</source>
        <translation>degrau do azimute</translation>
    </message>
    <message>
        <source>step of the elevation</source>
        <translation>degrau da elevação</translation>
    </message>
    <message>
        <source>ramp of the azimuth</source>
        <translation>rampa do azimute</translation>
    </message>
    <message>
        <source>ramp of the elevation</source>
        <translation>rampa da elevação</translation>
    </message>
    <message>
        <source>small swings of the azimuth</source>
        <translation>oscilações pequenas do azimute</translation>
    </message>
    <message>
        <source>small swings of the elevation</source>
        <translation>oscilações pequenas da elevação</translation>
    </message>
    <message>
        <source>backlash of the azimuth</source>
        <translation>folga do azimute</translation>
    </message>
    <message>
        <source>backlash of the elevation</source>
        <translation>folga da elevação</translation>
    </message>
    <message>
        <source>A calibration moves the mount. End it first.</source>
        <translation>Uma calibração move a montagem. Termine-a primeiro.</translation>
    </message>
    <message>
        <source>This mount has no such axis.</source>
        <translation>Esta montagem não tem esse eixo.</translation>
    </message>
    <message>
        <source>There is no result.</source>
        <translation>Não há resultado.</translation>
    </message>
    <message>
        <source>Overshoot %1: small.</source>
        <translation>Ultrapassagem %1: pequena.</translation>
    </message>
    <message>
        <source>Settled %1 s after the set-point: quick.</source>
        <translation>Estabilizou %1 s depois do comando: rápido.</translation>
    </message>
    <message>
        <source>Settled %1 s after the set-point: slow. Raise kp and kd together.</source>
        <translation>Estabilizou %1 s depois do comando: lento. Aumente kp e kd juntos.</translation>
    </message>
    <message>
        <source>Backlash %1 ± %2, seen at %3 of %4 reversals.</source>
        <translation>Folga %1 ± %2, vista em %3 de %4 inversões.</translation>
    </message>
    <message>
        <source>The motor needs %1 Nm in the gap and %2 Nm with the load.</source>
        <translation>O motor precisa de %1 Nm na folga e de %2 Nm com a carga.</translation>
    </message>
    <message>
        <source>%1 more accepted in %2 s. The last: %3</source>
        <translation>mais %1 aceites em %2 s. O último: %3</translation>
    </message>
    <message>
        <source>A tuning run moves the mount. End it first.</source>
        <translation>Está a decorrer uma medição de afinação. Termine-a primeiro.</translation>
    </message>
    <message>
        <source>This axis has no moteus drive.</source>
        <translation>A montagem não tem um acionamento destes para este eixo.</translation>
    </message>
    <message>
        <source>Two boards have the id %1. Switch the power off. Disconnect one board. Switch the power on again.</source>
        <translation>Duas placas têm o id %1. Desligue a alimentação. Desligue uma placa. Volte a ligar a alimentação.</translation>
    </message>
    <message>
        <source>Boresight is reading the drives. Wait a moment.</source>
        <translation>Os acionamentos estão a ser lidos. Espere alguns segundos.</translation>
    </message>
    <message>
        <source>The gear ratio in the drive is right, or it was not read.</source>
        <translation>A redução no acionamento é a do perfil, ou não foi lida.</translation>
    </message>
    <message>
        <source>The connected board is not the board that you confirmed. Check it again.</source>
        <translation>A placa ligada não é a que confirmou. Verifique de novo.</translation>
    </message>
    <message>
        <source>The board %1 has the id %2 now. Boresight read it back and stored it. Switch the power off. Connect the other board. Switch the power on.</source>
        <translation>A placa %1 tem agora o id %2. O Boresight releu-o e guardou-o. Desligue a alimentação. Ligue a outra placa. Ligue a alimentação.</translation>
    </message>
    <message>
        <source>The gear ratio of the %1 drive is %2 now. Boresight read it back and stored it, with the gains that depend on it. Press Fix next to write limits and speeds. Then check the tuning.</source>
        <translation>A redução do acionamento de %1 é agora %2. O Boresight releu-a e guardou-a, com os ganhos que dependem dela. Prima Corrigir a seguir para escrever limites e velocidades. Depois verifique a afinação.</translation>
    </message>
    <message>
        <source>Boresight is changing a board. Wait a moment.</source>
        <translation>Uma placa está a ser alterada. Espere alguns segundos.</translation>
    </message>
    <message>
        <source>New gains are on trial. This would store them, too. Store them or put them back first.</source>
        <translation>Há ganhos novos à experiência. Isto também os guardaria. Guarde-os ou reponha-os primeiro.</translation>
    </message>
    <message>
        <source>No gain differs from its first value.</source>
        <translation>Os ganhos estão como foram encontrados.</translation>
    </message>
    <message>
        <source>No gains are on trial. The drive has stored what it uses.</source>
        <translation>Não há ganhos à experiência. O acionamento guardou os que usa.</translation>
    </message>
    <message>
        <source>counts from a new zero, so Boresight checks its cable wrap again</source>
        <translation>conta a partir de um novo zero, por isso o Boresight verifica de novo a volta do cabo</translation>
    </message>
    <message>
        <source>%1 must be %2 to %3. %4</source>
        <translation>%1 pode ser de %2 a %3. %4</translation>
    </message>
    <message>
        <source>The %1 drive stopped replying. Read its gains again.</source>
        <translation>O acionamento de %1 perdeu-se entretanto. Leia os ganhos de novo.</translation>
    </message>
    <message>
        <source>%1 Nothing was stored. Switch the board off and on to restore its old settings.</source>
        <translation>%1 Nada foi guardado. Desligue e ligue a placa, e ela volta a ter as definições antigas.</translation>
    </message>
    <message>
        <source>No board with the id %1 answers. Nothing was changed.</source>
        <translation>Nenhuma placa responde com o id %1. Nada foi alterado.</translation>
    </message>
    <message>
        <source>The connected board %1 is not the board that you confirmed. Nothing was changed.</source>
        <translation>A placa ligada %1 não é a que confirmou. Nada foi alterado.</translation>
    </message>
    <message>
        <source>More than one board is connected. Leave only the board to change. Nothing was changed.</source>
        <translation>Há mais de uma placa ligada. Deixe só a placa a alterar. Nada foi alterado.</translation>
    </message>
    <message>
        <source>The board does not answer with the id %1.</source>
        <translation>A placa não responde com o id %1.</translation>
    </message>
    <message>
        <source>Another board appeared on the bus.</source>
        <translation>Outra placa foi ligada entretanto.</translation>
    </message>
    <message>
        <source>%1. The new settings are in force. It is unknown whether the board stored them. Switch it off and on, then check again.</source>
        <translation>%1. As novas definições estão em vigor. Não se sabe se a placa as guardou. Desligue-a e ligue-a, depois verifique de novo.</translation>
    </message>
    <message>
        <source>%1 cannot be read. Nothing was changed.</source>
        <translation>%1 não se pode ler. Nada foi alterado.</translation>
    </message>
    <message>
        <source>Listing the connected boards.</source>
        <translation>A ver que placas estão ligadas.</translation>
    </message>
    <message>
        <source>Reading the settings that depend on %1.</source>
        <translation>A ler as definições que dependem de %1.</translation>
    </message>
    <message>
        <source>Checking that the same board answers.</source>
        <translation>A ver se responde a mesma placa.</translation>
    </message>
    <message>
        <source>A quarter to four times the stored value. A larger change is probably a typing error.</source>
        <translation>De um quarto a quatro vezes o valor guardado. Uma alteração maior é provavelmente um engano.</translation>
    </message>
    <message>
        <source>At most ten times kp, or four times the stored value. A faster integral makes the axis oscillate.</source>
        <translation>Dez vezes kp, ou quatro vezes o valor guardado. Um integral mais rápido faz o eixo oscilar sozinho.</translation>
    </message>
    <message>
        <source>At most the torque of kp at an error of 0.1°, or four times the stored value.</source>
        <translation>O torque que kp dá com um erro de 0,1°, ou quatro vezes o valor guardado.</translation>
    </message>
    <message>
        <source>At most four times the inertia that fits kp and kd, or four times the stored value.</source>
        <translation>Quatro vezes a inércia adequada a kp e kd, ou quatro vezes o valor guardado.</translation>
    </message>
    <message>
        <source>Open the guide (F3), step Connect. It sets the ids of the boards one after the other. If there is only one board, check the plugs and the termination.</source>
        <translation>Abra o guia (F3), passo Ligar. Ele dá o id a uma placa após a outra. Se só há uma placa, verifique fichas e terminação.</translation>
    </message>
    <message>
        <source>Exchange the ids in the profile. If you exchanged the boards, end Boresight. Move the .memory.json files of the mount out of the state folder. Start Boresight again.</source>
        <translation>Troque os ids no perfil. Se trocou as placas, termine o Boresight. Tire os ficheiros .memory.json da montagem da pasta de estado. Inicie o Boresight de novo.</translation>
    </message>
    <message>
        <source>The drive reported no torque, so there is no result.</source>
        <translation>O acionamento não indicou binário, por isso não há resultado.</translation>
    </message>
    <message>
        <source>The axis reversed too few times, so there is no result.</source>
        <translation>O eixo inverteu o sentido poucas vezes, por isso não há resultado.</translation>
    </message>
    <message>
        <source>The backlash is larger than the movement of the run, so there is no result.</source>
        <translation>A folga é maior do que o movimento da medição, por isso não há resultado.</translation>
    </message>
    <message>
        <source>The torque shows no gap when the axis reverses, so there is no result. The backlash may be too small for the encoder. Weight or wind may keep the gear on one side.</source>
        <translation>O binário não mostra folga quando o eixo inverte o sentido, por isso não há resultado. A folga pode ser demasiado pequena para o codificador. O peso ou o vento podem manter a engrenagem de um lado.</translation>
    </message>
    <message>
        <source>The axis did not move at a constant rate for 1 s.</source>
        <translation>O eixo não se moveu a velocidade constante durante 1 s.</translation>
    </message>
    <message>
        <source>The recording after the step is too short.</source>
        <translation>O registo depois do degrau é demasiado curto.</translation>
    </message>
    <message>
        <source>The step is not larger than the settling band.</source>
        <translation>O degrau não é maior do que a faixa de estabilização.</translation>
    </message>
    <message>
        <source>The swing of the axis was too short.</source>
        <translation>A oscilação do eixo foi demasiado curta.</translation>
    </message>
    <message>
        <source>The set-point hardly moved.</source>
        <translation>O valor comandado quase não se moveu.</translation>
    </message>
    <message>
        <source>the tuning run ended because it received no new rate</source>
        <translation>a medição de afinação terminou porque não recebeu uma nova velocidade</translation>
    </message>
    <message>
        <source>STOP ended the run. There is no result.</source>
        <translation>STOP terminou a medição. Não há resultado.</translation>
    </message>
    <message>
        <source>A fault ended the run. There is no result.</source>
        <translation>Uma falha terminou a medição. Não há resultado.</translation>
    </message>
    <message>
        <source>Another command to the mount ended the run. There is no result.</source>
        <translation>Outro comando à montagem terminou a medição. Não há resultado.</translation>
    </message>
    <message>
        <source>No tuning run is active.</source>
        <translation>Nenhuma medição de afinação está ativa.</translation>
    </message>
    <message>
        <source>The operator ended the run. There is no result.</source>
        <translation>O operador terminou a medição. Não há resultado.</translation>
    </message>
    <message>
        <source>The clients have control. Take control before you tune an axis.</source>
        <translation>Os clientes têm o controlo. Assuma o controlo antes de afinar um eixo.</translation>
    </message>
    <message>
        <source>The limits of motion are too low for any swing.</source>
        <translation>Os limites de movimento são demasiado baixos para qualquer oscilação.</translation>
    </message>
    <message>
        <source>Overshoot %1: the axis moves past its target. Raise kd, or lower ki.</source>
        <translation>Ultrapassagem %1: o eixo passa além do alvo. Aumente kd ou reduza ki.</translation>
    </message>
    <message>
        <source>The axis does not settle within %1. Lower kp and ki, or raise kd.</source>
        <translation>O eixo não estabiliza dentro de %1. Reduza kp e ki, ou aumente kd.</translation>
    </message>
    <message>
        <source>An error of %1 remains. Friction or weight holds the axis. Raise ki or its limit.</source>
        <translation>Resta um erro de %1. O atrito ou o peso prende o eixo. Aumente ki ou o seu limite.</translation>
    </message>
    <message>
        <source>The axis tracks %1°/s within %2: good for every pass.</source>
        <translation>O eixo segue %1°/s com erro até %2: bom para qualquer passagem.</translation>
    </message>
    <message>
        <source>The error is up to %1 at %2°/s. Raise kp, then ki.</source>
        <translation>O erro chega a %1 a %2°/s. Aumente kp, depois ki.</translation>
    </message>
    <message>
        <source>The error at start and stop is %1. Raise the inertia feed-forward.</source>
        <translation>O erro no arranque e na paragem é %1. Aumente a compensação de inércia.</translation>
    </message>
    <message>
        <source>At %1 Hz the axis swings %2 times as far as commanded. Raise kd, or lower kp.</source>
        <translation>A %1 Hz o eixo oscila %2 vezes mais do que o comandado. Aumente kd ou reduza kp.</translation>
    </message>
    <message>
        <source>The axis follows all swings to %1 Hz.</source>
        <translation>O eixo segue todas as oscilações até %1 Hz.</translation>
    </message>
    <message>
        <source>The axis does not follow a swing at %1 Hz. Raise kp and kd together.</source>
        <translation>O eixo não segue uma oscilação a %1 Hz. Aumente kp e kd em conjunto.</translation>
    </message>
    <message>
        <source>The run needs %1 of free travel on both sides of the %2. There is only %3. Move the axis away from its limits.</source>
        <translation>A medição precisa de %1 de curso livre dos dois lados do %2. Só há %3. Afaste o eixo dos seus limites.</translation>
    </message>
    <message>
        <source>The run needs %1 of free travel on one side of the %2. There is only %3. Move the axis away from its limits.</source>
        <translation>A medição precisa de %1 de curso livre de um lado do %2. Só há %3. Afaste o eixo dos seus limites.</translation>
    </message>
    <message>
        <source>The mount is outside the permitted region. Move it back first.</source>
        <translation>A montagem está fora da região permitida. Traga-a de volta primeiro.</translation>
    </message>
    <message>
        <source>The axis is not moving. Something is blocking it, or a limit holds it</source>
        <translation>O eixo não se move. Algo o bloqueia, ou um limite prende-o</translation>
    </message>
    <message>
        <source>Boresight is scanning another bus. Wait a moment.</source>
        <translation>O Boresight está a examinar outro barramento. Espere um momento.</translation>
    </message>
    <message>
        <source>A reading is not a number.</source>
        <translation>Uma leitura não é um número.</translation>
    </message>
    <message>
        <source>The tilt is measured with the boom between %1 and %2.</source>
        <translation>A inclinação mede-se com a lança entre %1 e %2.</translation>
    </message>
    <message>
        <source>The tilt needs readings over at least %1 of azimuth.</source>
        <translation>A inclinação precisa de leituras em pelo menos %1 de azimute.</translation>
    </message>
    <message>
        <source>%1 readings are not enough for the tilt.</source>
        <translation>%1 leituras não bastam para a inclinação.</translation>
    </message>
    <message>
        <source>The readings do not determine the tilt. Take readings at more azimuths.</source>
        <translation>As leituras não determinam a inclinação. Faça leituras em mais azimutes.</translation>
    </message>
    <message>
        <source>Only %1 samples can be used. That is not enough for a swing.</source>
        <translation>Só se podem usar %1 amostras. Não bastam para um giro.</translation>
    </message>
    <message>
        <source>The position of the mount at sample %1 is unknown.</source>
        <translation>A posição da montagem na amostra %1 é desconhecida.</translation>
    </message>
    <message>
        <source>The heading of the sensor does not follow the mount in either direction.</source>
        <translation>O rumo do sensor não acompanha a montagem em nenhum dos sentidos.</translation>
    </message>
    <message>
        <source>%1 readings are not enough. A peak needs %2.</source>
        <translation>%1 leituras não bastam. Um pico precisa de %2.</translation>
    </message>
    <message>
        <source>The power has no peak along this line.</source>
        <translation>A potência não tem pico ao longo desta linha.</translation>
    </message>
    <message>
        <source>The peak is outside this line. Move the middle of the scan by at least %1 and scan again.</source>
        <translation>O pico está fora desta linha. Desloque o meio da varredura em pelo menos %1 e varra de novo.</translation>
    </message>
    <message>
        <source>The peak is narrower than the steps. Scan a smaller width.</source>
        <translation>O pico é mais estreito do que os passos. Varra uma largura menor.</translation>
    </message>
    <message>
        <source>The peak is uncertain by %1, because the readings scatter too much.</source>
        <translation>O pico é incerto em %1, porque as leituras se dispersam demasiado.</translation>
    </message>
    <message>
        <source>The power changes by only %1 dB along this line.</source>
        <translation>A potência varia apenas %1 dB ao longo desta linha.</translation>
    </message>
    <message>
        <source>The beam is too near to the zenith. The azimuth has no meaning there.</source>
        <translation>O feixe está perto demais do zénite. Ali o azimute não tem significado.</translation>
    </message>
    <message>
        <source>Point %1 is not a number or has no sigma.</source>
        <translation>O ponto %1 não é um número ou não tem sigma.</translation>
    </message>
    <message>
        <source>kept near its known value until there are %1 points</source>
        <translation>perto do que dele se sabia, até haver %1 pontos</translation>
    </message>
    <message>
        <source>kept at its known value until there are %1 points</source>
        <translation>como se conhecia, até haver %1 pontos</translation>
    </message>
    <message>
        <source>its known value counts as much as the points</source>
        <translation>o que dele se sabia pesa tanto quanto os pontos</translation>
    </message>
    <message>
        <source>The points scatter %1 times more than their sigmas.</source>
        <translation>Os pontos dispersam-se %1 vezes mais do que os seus sigmas.</translation>
    </message>
    <message>
        <source>All points lie within %1 of azimuth. They show the tilt from one side only.</source>
        <translation>Todos os pontos estão dentro de %1 de azimute. Mostram a inclinação só de um lado.</translation>
    </message>
    <message>
        <source>The points do not determine the azimuth offset.</source>
        <translation>Os pontos não determinam o desvio de azimute.</translation>
    </message>
    <message>
        <source>No model fits these points. Check the direction of each point.</source>
        <translation>Nenhum modelo se ajusta a estes pontos. Verifique a direção de cada ponto.</translation>
    </message>
    <message>
        <source>Magnetometer calibration is %1 of 3, but %2 is needed. Move the sensor in figures of eight, away from iron.</source>
        <translation>A calibração do magnetómetro é %1 de 3, mas é preciso %2. Mova o sensor em forma de oito, longe de ferro.</translation>
    </message>
    <message>
        <source>The sensor repeats one value to the last digit. Switch it off and on.</source>
        <translation>O sensor repete um valor até ao último dígito. Desligue-o e ligue-o.</translation>
    </message>
    <message>
        <source>Motor current %1 A disturbs the compass (limit %2 A, sensor.still_current_a). Wait a moment and try again.</source>
        <translation>A corrente do motor, %1 A, perturba a bússola (limite %2 A, sensor.still_current_a). Espere um momento e tente de novo.</translation>
    </message>
    <message>
        <source>The mount is moving. It must stand still.</source>
        <translation>A montagem move-se. Tem de estar parada.</translation>
    </message>
    <message>
        <source>The position of the mount is unknown.</source>
        <translation>A posição da montagem é desconhecida.</translation>
    </message>
    <message>
        <source>There are %1 readings, but %2 are needed.</source>
        <translation>Há %1 leituras, mas são precisas %2.</translation>
    </message>
    <message>
        <source>%1 readings are not enough, or they disagree. Take more.</source>
        <translation>%1 leituras não bastam, ou não concordam. Faça mais.</translation>
    </message>
    <message>
        <source>The readings drift. Take readings for a longer time.</source>
        <translation>As leituras derivam. Faça leituras durante mais tempo.</translation>
    </message>
    <message>
        <source>The readings disagree. They scatter by %1, and %2 of %3 are far off.</source>
        <translation>As leituras discordam. Dispersam-se em %1, e %2 de %3 estão muito longe.</translation>
    </message>
    <message>
        <source>with magnetometer calibration below %1</source>
        <translation>com a calibração do magnetómetro abaixo de %1</translation>
    </message>
    <message>
        <source>at a motor current above %1 A (sensor.swing_current_a)</source>
        <translation>com um motor acima de %1 A (sensor.swing_current_a)</translation>
    </message>
    <message>
        <source>The readings scatter by %1 about the curve.</source>
        <translation>As leituras dispersam-se em %1 em torno da curva.</translation>
    </message>
    <message>
        <source>Iron near the sensor deflects the compass by %1. It is nearly as strong as the field of the Earth.</source>
        <translation>O ferro perto do sensor desvia a bússola em %1. É quase tão forte como o campo da Terra.</translation>
    </message>
    <message>
        <source>The compass error is so steep that different directions give nearly the same reading.</source>
        <translation>O erro da bússola é tão íngreme que direções diferentes dão quase a mesma leitura.</translation>
    </message>
    <message>
        <source>%1 of %2 readings are far off the curve.</source>
        <translation>%1 de %2 leituras estão muito longe da curva.</translation>
    </message>
    <message>
        <source>%1 of the circle is unreliable.</source>
        <translation>%1 do círculo não são de confiança.</translation>
    </message>
    <message>
        <source>%1 of %2 readings were left out: %3.</source>
        <translation>%1 de %2 leituras foram omitidas: %3.</translation>
    </message>
    <message>
        <source>Only %1 of 12 sectors have readings, with a gap of %2. Soft iron could not be determined.</source>
        <translation>Só %1 de 12 setores têm leituras, com uma lacuna de %2. O ferro doce não pôde ser determinado.</translation>
    </message>
    <message>
        <source>Some sectors have few readings.</source>
        <translation>Alguns setores têm poucas leituras.</translation>
    </message>
    <message>
        <source>The mount turned in one direction only. Latency and hysteresis are unknown.</source>
        <translation>A montagem girou só num sentido. A latência e a histerese são desconhecidas.</translation>
    </message>
    <message>
        <source>The two directions of turning differ by %1. Either sensor.latency_s is wrong or the mount has play. North is the mean of both.</source>
        <translation>Os dois sentidos de giro diferem em %1. Ou sensor.latency_s está errado, ou a montagem tem folga. O norte é a média dos dois.</translation>
    </message>
    <message>
        <source>The curve is valid with the boom at %1. At %2 higher or lower it is uncertain by %3.</source>
        <translation>A curva vale com a lança a %1. A mais ou menos %2 é incerta em %3.</translation>
    </message>
    <message>
        <source>From %1 to %2 the compass is off by %3. It is unreliable there.</source>
        <translation>De %1 a %2 a bússola erra em %3. Ali não é de confiança.</translation>
    </message>
    <message>
        <source>The motor current turns the compass by %1.</source>
        <translation>A corrente dos motores desvia a bússola em %1.</translation>
    </message>
    <message>
        <source>In %1 of %2 readings the magnetometer calibration is below %3. Move the sensor in figures of eight, away from iron. Then swing again.</source>
        <translation>Em %1 de %2 leituras a calibração do magnetómetro está abaixo de %3. Mova o sensor em forma de oito, longe de ferro. Depois repita o giro.</translation>
    </message>
    <message>
        <source>In %1 of %2 readings the motor current is above %3 A (sensor.swing_current_a). Look for what blocks the mount, or raise this limit.</source>
        <translation>Em %1 de %2 leituras a corrente do motor está acima de %3 A (sensor.swing_current_a). Veja o que bloqueia a montagem, ou aumente esse limite.</translation>
    </message>
    <message>
        <source>%1 of 12 sectors have readings, with a gap of %2. A swing needs more of the circle. Find north with the mount standing still instead.</source>
        <translation>%1 de 12 setores têm leituras, com uma lacuna de %2. Um giro precisa de mais do círculo. Ache antes o norte com a montagem parada.</translation>
    </message>
    <message>
        <source>The points do not determine the azimuth offset. Take a point away from the zenith.</source>
        <translation>Os pontos não determinam o desvio de azimute. Tome um ponto longe do zénite.</translation>
    </message>
    <message>
        <source>%1 is missing. Write every term, also a term that is 0.</source>
        <translation>Falta %1. Escreva cada termo, também um termo que é 0.</translation>
    </message>
    <message>
        <source>%1 is not a date like 2026-11-21T21:34:00Z.</source>
        <translation>%1 não é uma data como 2026-11-21T21:34:00Z.</translation>
    </message>
    <message>
        <source>%1 is not a site. Write latitude, longitude and height, like 48.2 16.37 200.</source>
        <translation>%1 não é um local. Escreva latitude, longitude e altura, como 48.2 16.37 200.</translation>
    </message>
    <message>
        <source>%1 is not a known term.</source>
        <translation>%1 não é um termo conhecido.</translation>
    </message>
    <message>
        <source>%1 is already in line %2.</source>
        <translation>%1 já está na linha %2.</translation>
    </message>
    <message>
        <source>The value of %1 is missing.</source>
        <translation>Falta o valor de %1.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 não é um número.</translation>
    </message>
    <message>
        <source>The unit of %1 is missing. Write deg, arcmin or arcsec.</source>
        <translation>Falta a unidade de %1. Escreva deg, arcmin ou arcsec.</translation>
    </message>
    <message>
        <source>%1 is not a known unit. Write deg, arcmin or arcsec.</source>
        <translation>%1 não é uma unidade conhecida. Escreva deg, arcmin ou arcsec.</translation>
    </message>
    <message>
        <source>%1 is one value too many. A line has name, value, unit and sigma.</source>
        <translation>%1 é um valor a mais. Uma linha tem nome, valor, unidade e sigma.</translation>
    </message>
    <message>
        <source>%1 is not a sigma. Write a number above 0, or - for an unknown one.</source>
        <translation>%1 não é um sigma. Escreva um número acima de 0, ou - se for desconhecido.</translation>
    </message>
    <message>
        <source>%1 is too long to be the terms of a pointing model.</source>
        <translation>%1 é longo demais para os termos de um modelo de apontamento.</translation>
    </message>
    <message>
        <source>%1 is too large for a World Magnetic Model.</source>
        <translation>%1 é grande demais para um World Magnetic Model.</translation>
    </message>
    <message>
        <source>The term n = %1, m = %2 is missing.</source>
        <translation>Falta o termo n = %1, m = %2.</translation>
    </message>
    <message>
        <source>A line of nines must follow degree %1.</source>
        <translation>Depois do grau %1 tem de vir uma linha de noves.</translation>
    </message>
    <message>
        <source>The file ends without a line of nines.</source>
        <translation>O ficheiro termina sem uma linha de noves.</translation>
    </message>
    <message>
        <source>This is not the header of a magnetic model. A header has an epoch, a name and a date.</source>
        <translation>Isto não é o cabeçalho de um modelo magnético. Um cabeçalho tem uma época, um nome e uma data.</translation>
    </message>
    <message>
        <source>The line has %1 numbers instead of 6: n, m, g, h and the changes of g and h.</source>
        <translation>A linha tem %1 números em vez de 6: n, m, g, h e as variações de g e h.</translation>
    </message>
    <message>
        <source>The term n = %1, m = %2 must come here.</source>
        <translation>Aqui tem de vir o termo n = %1, m = %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number.</source>
        <translation>&quot;%1&quot; não é um número.</translation>
    </message>
    <message>
        <source>In a term with m = 0, h must be 0.</source>
        <translation>Num termo com m = 0, h tem de ser 0.</translation>
    </message>
    <message>
        <source>The magnetic model %1 is valid from %2 to %3, not in %4. Get the present World Magnetic Model (.COF), or enter the declination.</source>
        <translation>O modelo magnético %1 vale de %2 a %3, não em %4. Obtenha o World Magnetic Model atual (.COF), ou escreva a declinação.</translation>
    </message>
    <message>
        <source>The sensor followed the axis since the cable wrap was known. It shows %1 (± %2).</source>
        <translation>O sensor acompanhou o eixo desde que a volta do cabo era conhecida. Mostra %1 (± %2).</translation>
    </message>
    <message>
        <source> This contradicts %1, so Boresight proposes nothing. Look at the cable.</source>
        <translation> Isto contradiz %1, por isso o Boresight não propõe nada. Olhe para o cabo.</translation>
    </message>
    <message>
        <source> This agrees with the proposal.</source>
        <translation> Isto concorda com a proposta.</translation>
    </message>
    <message>
        <source>it is too large for a position journal</source>
        <translation>é grande demais para a memória de uma montagem</translation>
    </message>
    <message>
        <source>The journal file %1 cannot be used: %2. Boresight keeps it as %3</source>
        <translation>O ficheiro do diário %1 não pode ser usado: %2. O Boresight guarda-o como %3</translation>
    </message>
    <message>
        <source>The journal file %1 cannot be used: %2. Boresight could not rename it</source>
        <translation>O ficheiro do diário %1 não pode ser usado: %2. O Boresight não pôde mudar-lhe o nome</translation>
    </message>
    <message>
        <source>%1 already controls this mount. Its journal %2 is in use</source>
        <translation>%1 já controla esta montagem. O seu diário %2 está em uso</translation>
    </message>
    <message>
        <source>it is damaged at byte %1: %2</source>
        <translation>está cortado ou danificado no byte %1: %2</translation>
    </message>
    <message>
        <source>it is not a position journal</source>
        <translation>não é um diário de posições</translation>
    </message>
    <message>
        <source>it has version %1, but this program reads version %2</source>
        <translation>este programa não conhece a sua versão %1; lê a versão %2</translation>
    </message>
    <message>
        <source>its checksum is wrong, so it was changed or damaged</source>
        <translation>a sua soma de verificação está errada: foi alterado ou danificado</translation>
    </message>
    <message>
        <source>The journal is dated %1 in the future. The clock of this computer was set back</source>
        <translation>O diário tem data de %1 no futuro. O relógio deste computador foi atrasado</translation>
    </message>
    <message>
        <source>This computer restarted, and its clock is not synchronised. It is unknown whether the drive kept its power</source>
        <translation>Este computador foi reiniciado, e o seu relógio não está sincronizado. Não se sabe se o acionamento manteve a alimentação</translation>
    </message>
    <message>
        <source>The clock of the drive restarts every 49.7 days. It is unknown whether the drive kept its power</source>
        <translation>O relógio do acionamento recomeça a cada 49.7 dias. Não se sabe se o acionamento manteve a alimentação</translation>
    </message>
    <message>
        <source>The clocks of the drive and of this computer disagree about the time since the journal. It is unknown whether the drive kept its power</source>
        <translation>Os relógios do acionamento e deste computador discordam sobre o tempo desde o diário. Não se sabe se o acionamento manteve a alimentação</translation>
    </message>
    <message>
        <source>The encoder settings of the drive were changed. It counts from a new zero</source>
        <translation>As definições do encoder do acionamento foram alteradas. Ele conta de um novo zero</translation>
    </message>
    <message>
        <source>The position of the drive was set by a command. The change is not a motion</source>
        <translation>A posição do acionamento foi definida por um comando. A mudança não é um movimento</translation>
    </message>
    <message>
        <source>The zero of the drive was set or lost after the journal was written</source>
        <translation>O zero do acionamento foi definido ou perdido desde que o diário foi escrito</translation>
    </message>
    <message>
        <source>Zero, direction or gear of the axis were changed after the journal was written</source>
        <translation>O zero, o sentido ou a redução do eixo foram alterados desde que o diário foi escrito</translation>
    </message>
    <message>
        <source>The drive does not know the position of the axis. Enter the angle</source>
        <translation>O acionamento não sabe a posição do eixo. Escreva o ângulo</translation>
    </message>
    <message>
        <source>The angle is known only to a multiple of %1. %2 places from %3 to %4 are possible</source>
        <translation>O ângulo só se conhece a menos de um múltiplo de %1. São possíveis %2 lugares de %3 a %4</translation>
    </message>
    <message>
        <source>Direction %1 is known, but not the cable wrap. %2 are possible</source>
        <translation>A direção %1 é conhecida, mas a volta do cabo não. São possíveis %2</translation>
    </message>
    <message>
        <source>The angle is known only to a multiple of %1. %2 are possible</source>
        <translation>O ângulo só se conhece a menos de um múltiplo de %1. São possíveis %2</translation>
    </message>
    <message>
        <source>The journal has no entry for this axis</source>
        <translation>O diário não tem registo deste eixo</translation>
    </message>
    <message>
        <source>The journal has %1, written in motion</source>
        <translation>O diário tem %1, escrito em movimento</translation>
    </message>
    <message>
        <source>The journal has %1, written at standstill</source>
        <translation>O diário tem %1, escrito em repouso</translation>
    </message>
    <message>
        <source>The journal has %1, %2 old, written in motion</source>
        <translation>O diário tem %1, escrito em movimento há %2</translation>
    </message>
    <message>
        <source>The journal has %1, %2 old, written at standstill</source>
        <translation>O diário tem %1, escrito em repouso há %2</translation>
    </message>
    <message>
        <source>The sensor reports %1</source>
        <translation>O sensor indica %1</translation>
    </message>
    <message>
        <source>The station has not reported yet.</source>
        <translation>A estação ainda não comunicou nada.</translation>
    </message>
    <message>
        <source>The console of the drive sends without end. Send &quot;tel stop&quot;.</source>
        <translation>A consola do acionamento envia sem parar. Envie &quot;tel stop&quot;.</translation>
    </message>
    <message>
        <source>The console of the drive did not answer the command.</source>
        <translation>A consola do acionamento não respondeu ao comando.</translation>
    </message>
    <message>
        <source>The drive answers: %1</source>
        <translation>O acionamento responde: %1</translation>
    </message>
    <message>
        <source>Drive %1 does not answer on its console.</source>
        <translation>O acionamento %1 não responde na sua consola.</translation>
    </message>
    <message>
        <source>Part of the answer was lost. Repeat the command.</source>
        <translation>Perdeu-se uma parte da resposta. Repita o comando.</translation>
    </message>
    <message>
        <source>A user name and a password are required. Set mqtt.user and mqtt.password</source>
        <translation>São precisos um nome de utilizador e uma palavra-passe. Defina mqtt.user e mqtt.password</translation>
    </message>
    <message>
        <source>The broker refuses the user &quot;%1&quot; or the password. Check mqtt.user and mqtt.password</source>
        <translation>O broker recusa o utilizador &quot;%1&quot; ou a palavra-passe. Verifique mqtt.user e mqtt.password</translation>
    </message>
    <message>
        <source>Is mqtt.port the TLS port of the broker?</source>
        <translation>A porta mqtt.port é a porta TLS do broker?</translation>
    </message>
    <message>
        <source>Is mqtt.port right? Does this port need TLS?</source>
        <translation>A porta mqtt.port está certa? Esta porta exige TLS?</translation>
    </message>
    <message>
        <source>The encryption failed (%1). %2</source>
        <translation>A cifra falhou (%1). %2</translation>
    </message>
    <message>
        <source>Boresight does not trust the broker: %1</source>
        <translation>O Boresight não confia no broker: %1</translation>
    </message>
    <message>
        <source>The broker refuses MQTT 3.1.1. Use a newer broker</source>
        <translation>O broker recusa MQTT 3.1.1. Use um broker mais novo</translation>
    </message>
    <message>
        <source>The broker refuses the client id &quot;%1&quot;. Change mqtt.client_id</source>
        <translation>O broker recusa o identificador de cliente &quot;%1&quot;. Mude mqtt.client_id</translation>
    </message>
    <message>
        <source>The broker reports that it is not available</source>
        <translation>O broker comunica que não está disponível</translation>
    </message>
    <message>
        <source>The name cannot be resolved (%1). Check mqtt.host and the network</source>
        <translation>O nome não foi encontrado (%1). Verifique mqtt.host e a rede</translation>
    </message>
    <message>
        <source>No connection (%1). Is the broker running there?</source>
        <translation>Sem ligação (%1). O broker está a correr ali?</translation>
    </message>
    <message>
        <source>No answer. Check mqtt.host, the network and the firewall</source>
        <translation>Sem resposta. Verifique mqtt.host, a rede e a firewall</translation>
    </message>
    <message>
        <source>The port accepts the connection but does not answer. %1</source>
        <translation>A porta aceita a ligação, mas não responde. %1</translation>
    </message>
    <message>
        <source>The port closes the connection before it answers. %1</source>
        <translation>A porta fecha a ligação antes de responder. %1</translation>
    </message>
    <message>
        <source>The connection is lost (%1)</source>
        <translation>A ligação perdeu-se (%1)</translation>
    </message>
    <message>
        <source>The broker closes the connection soon after the login. Was the broker stopped? Does another program use the client id &quot;%1&quot;?</source>
        <translation>O broker fecha a ligação pouco depois do início de sessão. O broker foi parado? Outro programa usa o identificador de cliente &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>The connection is lost (no more data)</source>
        <translation>A ligação perdeu-se (sem mais dados)</translation>
    </message>
    <message>
        <source>The answer is not MQTT. %1</source>
        <translation>A resposta não é MQTT. %1</translation>
    </message>
    <message>
        <source>Encryption cannot be set up: %1</source>
        <translation>A cifra não pode ser preparada: %1</translation>
    </message>
    <message>
        <source>No certificate of an authority can be read from %1 (%2). Check mqtt.ca_file</source>
        <translation>Não se pode ler de %1 nenhum certificado de uma autoridade (%2). Verifique mqtt.ca_file</translation>
    </message>
    <message>
        <source>its certificate has expired, or the clock of this computer is wrong</source>
        <translation>o seu certificado expirou, ou o relógio deste computador está errado</translation>
    </message>
    <message>
        <source>its certificate is not valid yet, or the clock of this computer is wrong</source>
        <translation>o seu certificado ainda não é válido, ou o relógio deste computador está errado</translation>
    </message>
    <message>
        <source>its certificate is not for &quot;%1&quot;. Check mqtt.host</source>
        <translation>o seu certificado não é para &quot;%1&quot;. Verifique mqtt.host</translation>
    </message>
    <message>
        <source>its certificate is not from the authority in %1. Check mqtt.ca_file</source>
        <translation>o seu certificado não é da autoridade em %1. Verifique mqtt.ca_file</translation>
    </message>
    <message>
        <source>The %1 is below the horizon.</source>
        <translation>%1 está abaixo do horizonte.</translation>
    </message>
    <message>
        <source>stopped tracking the %1, because the mount got another command</source>
        <translation>deixou de seguir o %1, porque a montagem recebeu outro comando</translation>
    </message>
    <message>
        <source>stopped tracking the %1</source>
        <translation>deixou de seguir o %1</translation>
    </message>
    <message>
        <source>The terms or the sensor in the profile were changed.</source>
        <translation>Os termos ou o sensor no perfil foram alterados.</translation>
    </message>
    <message>
        <source>There are no points.</source>
        <translation>Não há pontos.</translation>
    </message>
    <message>
        <source>The calibrations could not be written: %1</source>
        <translation>As calibrações não puderam ser gravadas: %1</translation>
    </message>
    <message>
        <source>A calibration is running. End it first.</source>
        <translation>Há uma calibração em curso. Termine-a primeiro.</translation>
    </message>
    <message>
        <source>The position of the %1 is unknown.</source>
        <translation>A posição é desconhecida: %1.</translation>
    </message>
    <message>
        <source>Track the %1 first.</source>
        <translation>Siga primeiro o astro: %1.</translation>
    </message>
    <message>
        <source>Nothing is proposed yet.</source>
        <translation>Ainda não há nada proposto.</translation>
    </message>
    <message>
        <source>There is no calibration to undo.</source>
        <translation>Não há calibração para anular.</translation>
    </message>
    <message>
        <source>There is no calibration to redo.</source>
        <translation>Não há calibração para refazer.</translation>
    </message>
    <message>
        <source>No scan waits for a power value.</source>
        <translation>Nenhuma varredura espera por uma potência.</translation>
    </message>
    <message>
        <source>The azimuth axis shows 0° at a true azimuth of %1 ± %2</source>
        <translation>O eixo de azimute mostra 0° num azimute verdadeiro de %1 ± %2</translation>
    </message>
    <message>
        <source>North is known only to %1. Use the Sun or the Moon for a better value.</source>
        <translation>O norte só se conhece a %1. Use o Sol ou a Lua para um valor melhor.</translation>
    </message>
    <message>
        <source>North stays unchanged. It is known to %1, by compass only to %2.</source>
        <translation>O norte não muda. Conhece-se a %1, pela bússola só a %2.</translation>
    </message>
    <message>
        <source>The tilt stays unchanged. It is known to %1, by a swing only to %2.</source>
        <translation>A inclinação não muda. Conhece-se a %1, por um giro só a %2.</translation>
    </message>
    <message>
        <source>The tilt of the mast differs by %1 from the tilt in force. Check that the mast is firm.</source>
        <translation>A inclinação do mastro difere em %1 da inclinação em vigor. Verifique se o mastro está firme.</translation>
    </message>
    <message>
        <source>. The azimuth axis leans by %1 ± %2 towards %3</source>
        <translation>. O eixo de azimute inclina-se %1 ± %2 para %3</translation>
    </message>
    <message>
        <source>This is too much to correct. Check how the sensor sits on the boom and what the elevation axis shows.</source>
        <translation>É demasiado para corrigir. Verifique como o sensor está na lança e o que o eixo de elevação mostra.</translation>
    </message>
    <message>
        <source>Sensor and elevation axis differ by %1.</source>
        <translation>O sensor e o eixo de elevação diferem em %1.</translation>
    </message>
    <message>
        <source>This is more than a tilted sensor. The zero of the elevation axis is wrong.</source>
        <translation>É mais do que um sensor inclinado. O zero do eixo de elevação está errado.</translation>
    </message>
    <message>
        <source>The zero of elevation moves by %1. First check that the sensor lies along the boom.</source>
        <translation>O zero da elevação muda %1. Verifique antes se o sensor está alinhado com a lança.</translation>
    </message>
    <message>
        <source>. At 0° of the elevation axis the sensor reports %1 ± %2. %3</source>
        <translation>. A 0° do eixo de elevação o sensor indica %1 ± %2. %3</translation>
    </message>
    <message>
        <source>The sensor will agree at this heading only. A new swing corrects all headings.</source>
        <translation>O sensor vai concordar só neste rumo. Um novo giro corrige todos os rumos.</translation>
    </message>
    <message>
        <source>The sensor keeps the north of its swing. Sensor and axes will then differ by %1.</source>
        <translation>O sensor mantém o norte do seu giro. O sensor e os eixos vão então diferir em %1.</translation>
    </message>
    <message>
        <source>The text belongs to another mount: &quot;%1&quot;.</source>
        <translation>O texto é de outra montagem: &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>The text belongs to another azimuth drive. The zero of its axis may differ.</source>
        <translation>O texto é de outro acionamento de azimute. O zero do seu eixo pode ser outro.</translation>
    </message>
    <message>
        <source>The text belongs to another elevation drive. The zero of its axis may differ.</source>
        <translation>O texto é de outro acionamento de elevação. O zero do seu eixo pode ser outro.</translation>
    </message>
    <message>
        <source>The text belongs to another site. North and tilt may differ.</source>
        <translation>O texto é de outro local. O norte e a inclinação podem ser outros.</translation>
    </message>
    <message>
        <source>The mount tracks the %1. Press Hold first.</source>
        <translation>A montagem segue um astro: %1. Prima primeiro Manter.</translation>
    </message>
    <message>
        <source>There are already %1 points. Drop some.</source>
        <translation>Já há %1 pontos. Retire alguns.</translation>
    </message>
    <message>
        <source>The orientation sensor has sent nothing for %1 s.</source>
        <translation>O sensor de orientação não envia nada há %1 s.</translation>
    </message>
    <message>
        <source>The orientation sensor has sent nothing yet.</source>
        <translation>O sensor de orientação ainda não enviou nada.</translation>
    </message>
    <message>
        <source>The profile has no orientation sensor.</source>
        <translation>O perfil não tem sensor de orientação.</translation>
    </message>
    <message>
        <source>Magnetometer calibration is only %1 of 3, but %2 is needed. Move the sensor in figures of eight.</source>
        <translation>A calibração do magnetómetro é só %1 de 3, mas é preciso %2. Mova o sensor em forma de oito.</translation>
    </message>
    <message>
        <source>The park position would then be forbidden: %1. Set another one first (tab Mount, Profile, &quot;park&quot;). Then apply.</source>
        <translation>A posição de estacionar seria então proibida: %1. Defina outra primeiro (separador Montagem, Perfil, &quot;park&quot;). Depois aplique.</translation>
    </message>
    <message>
        <source>undoes &quot;%1&quot;</source>
        <translation>desfaz &quot;%1&quot;</translation>
    </message>
    <message>
        <source>The pointing model was changed after that: %1. This change would be lost. Undo it on the page Profile first, or type the terms.</source>
        <translation>O modelo de apontamento foi alterado depois disso: %1. Essa alteração perder-se-ia. Anule-a primeiro na página Perfil, ou escreva os termos.</translation>
    </message>
    <message>
        <source>The mounting or the compass error of the sensor was changed after that. This change would be lost. Undo it on the page Profile first.</source>
        <translation>A posição de montagem ou o erro de bússola do sensor foi alterado depois disso. Essa alteração perder-se-ia. Anule-a primeiro na página Perfil.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was applied with another drive or at another site. Check north before you rely on it</source>
        <translation>&quot;%1&quot; foi aplicada com outro acionamento ou noutro local. Verifique o norte antes de confiar nela</translation>
    </message>
    <message>
        <source>There is no point %1.</source>
        <translation>Não há ponto %1.</translation>
    </message>
    <message>
        <source>These points wait until every drive has reported its identity.</source>
        <translation>Estes pontos esperam até que todos os acionamentos tenham indicado a sua identidade.</translation>
    </message>
    <message>
        <source>Track the Sun or the Moon first and centre it.</source>
        <translation>Siga primeiro o Sol ou a Lua e centre-o.</translation>
    </message>
    <message>
        <source>The azimuth must be within 360° and the elevation within 90°.</source>
        <translation>O azimute tem de estar dentro de 360° e a elevação dentro de 90°.</translation>
    </message>
    <message>
        <source>These terms are already in force.</source>
        <translation>Estes termos já estão em vigor.</translation>
    </message>
    <message>
        <source>The settings of the sensor or the declination changed, so the proposal is dropped. Measure again</source>
        <translation>As definições do sensor ou a declinação mudaram, por isso a proposta foi retirada. Meça de novo</translation>
    </message>
    <message>
        <source>The proposal has changed. Read it again first.</source>
        <translation>A proposta mudou. Leia-a primeiro de novo.</translation>
    </message>
    <message>
        <source>The width of a scan must be %1° to %2°.</source>
        <translation>A largura de uma varredura tem de ser de %1° a %2°.</translation>
    </message>
    <message>
        <source>This is not a power in dB.</source>
        <translation>Isto não é uma potência em dB.</translation>
    </message>
    <message>
        <source>The beam was trimmed by hand during the scan.</source>
        <translation>O feixe foi compensado à mão durante a varredura.</translation>
    </message>
    <message>
        <source>The beam cannot reach a place of the scan: %1</source>
        <translation>O feixe não chega a um lugar da varredura: %1</translation>
    </message>
    <message>
        <source>done, and the peak is a point now</source>
        <translation>feito: o pico é agora um ponto</translation>
    </message>
    <message>
        <source>No power reading received.</source>
        <translation>Não foi recebida nenhuma leitura de potência.</translation>
    </message>
    <message>
        <source>The mount does not stand still.</source>
        <translation>A montagem não está parada.</translation>
    </message>
    <message>
        <source>Clients have control. Take control before the swing.</source>
        <translation>Os clientes têm o controlo. Assuma o controlo antes do giro.</translation>
    </message>
    <message>
        <source>The sensor restarted during the swing. Its compass may have another zero now.</source>
        <translation>O sensor reiniciou durante o giro. A sua bússola pode ter agora outro zero.</translation>
    </message>
    <message>
        <source>The mount is not moving. Something is blocking it.</source>
        <translation>A montagem não se move. Algo a bloqueia.</translation>
    </message>
    <message>
        <source>sensor data is back, and the swing continues</source>
        <translation>o sensor volta a ouvir-se: o giro da bússola continua</translation>
    </message>
    <message>
        <source>the swing pauses for at most %1 s: %2</source>
        <translation>o giro da bússola fica parado %1 s no máximo: %2</translation>
    </message>
    <message>
        <source>The sensor was silent and does not report its calibration. If it restarted, repeat the swing.</source>
        <translation>O sensor esteve em silêncio e não comunica a sua calibração. Se reiniciou, repita o giro.</translation>
    </message>
    <message>
        <source>A compass does not work here. %1</source>
        <translation>Aqui uma bússola não funciona. %1</translation>
    </message>
    <message>
        <source>The rate of a swing must be %1 to %2°/s.</source>
        <translation>A velocidade de um giro tem de ser de %1 a %2°/s.</translation>
    </message>
    <message>
        <source>A swing has %1 to %2 stops, or none.</source>
        <translation>Um giro tem de %1 a %2 paragens, ou nenhuma.</translation>
    </message>
    <message>
        <source>Only %1 of azimuth is free at this elevation. A swing needs %2. Raise the boom.</source>
        <translation>Só %1 de azimute estão livres nesta elevação. Um giro precisa de %2. Levante a lança.</translation>
    </message>
    <message>
        <source>no tilt at this elevation (it is measured between %1 and %2, best at 30°)</source>
        <translation>sem inclinação nesta elevação: lê-se entre %1 e %2, o melhor é 30°</translation>
    </message>
    <message>
        <source>raise the boom to 30° first for the best tilt and curve</source>
        <translation>melhor levantar antes a lança a 30°: ali leem-se melhor a inclinação e a curva</translation>
    </message>
    <message>
        <source>With the boom at %1 the compass does not work. Lower it to %2 or less, best to 30°.</source>
        <translation>Com a lança a %1 a bússola não funciona. Baixe-a a %2 ou menos, de preferência a 30°.</translation>
    </message>
    <message>
        <source>The mount is outside the permitted region. Jog it back inside first.</source>
        <translation>A montagem está fora da região permitida. Leve-a primeiro para dentro, à mão.</translation>
    </message>
    <message>
        <source>waiting for sensor data, for at most %1 s more</source>
        <translation>parado até o sensor voltar a ouvir-se, mais %1 s no máximo</translation>
    </message>
    <message>
        <source>moving to the start of the swing</source>
        <translation>indo para onde o giro começa</translation>
    </message>
    <message>
        <source>%1: The broker does not permit reading %2. Permit it in the access list (ACL) of the broker, or set mqtt.user and mqtt.password</source>
        <translation>%1: O broker não permite ler %2. Permita-o na lista de acesso (ACL) do broker, ou defina mqtt.user e mqtt.password</translation>
    </message>
    <message>
        <source>%1: The broker does not permit reading %2. Permit it in the access list (ACL) of the broker for the user &quot;%3&quot;</source>
        <translation>%1: O broker não permite ler %2. Permita-o na lista de acesso (ACL) do broker ao utilizador &quot;%3&quot;</translation>
    </message>
    <message>
        <source>%1: On %2 the broker has only an old stored value. Does the sensor have power and WiFi?</source>
        <translation>%1: Em %2 o broker só tem um valor antigo guardado. O sensor tem energia e WiFi?</translation>
    </message>
    <message>
        <source>%1: The messages on %2 are not from the sensor (%3)</source>
        <translation>%1: o que chega em %2 não é mensagem do sensor (%3)</translation>
    </message>
    <message>
        <source>%1: No data on %2. Does the sensor have power and WiFi? Is this its topic? Does the access list of the broker permit reading it?</source>
        <translation>%1: Sem dados em %2. O sensor tem energia e WiFi? Este é o seu tópico? A lista de acesso do broker permite lê-lo?</translation>
    </message>
    <message>
        <source>%1: No data. Does the sensor have power and WiFi? Without WiFi it sends nothing</source>
        <translation>%1: Sem dados. O sensor tem energia e WiFi? Sem WiFi não envia nada</translation>
    </message>
    <message>
        <source>%1: The data is damaged or not from the sensor. Is sensor.baud (%2) right?</source>
        <translation>%1: Os dados estão danificados ou não são do sensor. sensor.baud (%2) está certo?</translation>
    </message>
    <message>
        <source>%1: The data is not from the sensor: &quot;%2&quot;</source>
        <translation>%1: Os dados não são do sensor: &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1 is gone. Plug the sensor in again</source>
        <translation>%1 desapareceu. Volte a ligar o sensor</translation>
    </message>
    <message>
        <source>%1 is gone. Plug the sensor in again, in any socket. Boresight finds it as %2</source>
        <translation>%1 desapareceu. Volte a ligar o sensor, em qualquer tomada. O Boresight encontra-o como %2</translation>
    </message>
    <message>
        <source>a forbidden region</source>
        <translation>o que é proibido</translation>
    </message>
    <message>
        <source>Boresight found no way from %1 to %2 in time. There are too many keep-outs.</source>
        <translation>O Boresight não achou a tempo um caminho de %1 para %2. Há zonas proibidas a mais.</translation>
    </message>
    <message>
        <source>There is no way from %1 to %2. Between them is %3.</source>
        <translation>Não há caminho de %1 para %2. No meio está %3.</translation>
    </message>
    <message>
        <source>%1: No data. Is the program of the receiver running? Does it send to this address?</source>
        <translation>%1: Sem dados. O programa do recetor está a correr? Envia para este endereço?</translation>
    </message>
    <message>
        <source>%1: The data is not a power in dB: %2</source>
        <translation>%1: o que chega não é uma potência em dB: %2</translation>
    </message>
    <message>
        <source>Boresight cannot listen on %1: %2</source>
        <translation>O Boresight não pode escutar em %1: %2</translation>
    </message>
    <message>
        <source>%1: No connection to the program of the receiver: %2</source>
        <translation>%1: Sem ligação ao programa do recetor: %2</translation>
    </message>
    <message>
        <source>it contains no number</source>
        <translation>não há um número nela</translation>
    </message>
    <message>
        <source>it contains several numbers, and none is clearly the power</source>
        <translation>não é certo qual dos seus números é a potência</translation>
    </message>
    <message>
        <source>its number is ambiguous</source>
        <translation>o seu número não pode ser lido com certeza</translation>
    </message>
    <message>
        <source>a power above %1 dB is not possible</source>
        <translation>mais de %1 dB não é uma potência</translation>
    </message>
    <message>
        <source>%1 must reach %2°/s within %3 s. The permitted %4 Nm are enough for a moment of inertia of at most %5 kg·m², without friction and wind</source>
        <translation>%1 tem de atingir %2°/s em %3 s. Os %4 Nm permitidos chegam para um momento de inércia de no máximo %5 kg·m², sem atrito nem vento</translation>
    </message>
    <message>
        <source>a latitude or longitude is out of range</source>
        <translation>um lugar não está no globo</translation>
    </message>
    <message>
        <source>no file descriptor is free, so new clients wait</source>
        <translation>não restam descritores: novos clientes esperam</translation>
    </message>
    <message>
        <source>is not a rotctld client (%1)</source>
        <translation>não é um cliente rotctld (%1)</translation>
    </message>
    <message>
        <source>ended the session</source>
        <translation>despediu-se</translation>
    </message>
    <message>
        <source>raw commands to the drives are not permitted</source>
        <translation>comandos diretos não têm caminho até aos acionamentos</translation>
    </message>
    <message>
        <source>has disconnected, so its motion ends</source>
        <translation>foi-se, e o seu movimento termina</translation>
    </message>
    <message>
        <source>A trim can be at most %1°.</source>
        <translation>Uma compensação pode ser no máximo de %1°.</translation>
    </message>
    <message>
        <source>the profile was not applied, so the previous profile stays in force: %1</source>
        <translation>o perfil não foi aplicado, o perfil anterior continua em vigor: %1</translation>
    </message>
    <message>
        <source>the profile was read again. These settings wait for a restart: %1</source>
        <translation>o perfil foi lido de novo. Estas definições esperam por um reinício: %1</translation>
    </message>
    <message>
        <source>MQTT broker %1: a message of %2 kB was dropped. The limit is %3 kB</source>
        <translation>Broker MQTT %1: foi descartada uma mensagem de %2 kB. O limite é %3 kB</translation>
    </message>
    <message>
        <source>disconnected: %1</source>
        <translation>saiu: %1</translation>
    </message>
    <message>
        <source>The motor is still at %1 °C. It must cool down to %2 °C.</source>
        <translation>O motor ainda está a %1 °C. Tem de arrefecer até %2 °C.</translation>
    </message>
    <message>
        <source>The drive board is still at %1 °C. It must cool down to %2 °C.</source>
        <translation>A placa do acionamento ainda está a %1 °C. Tem de arrefecer até %2 °C.</translation>
    </message>
    <message>
        <source>The supply is still at %1 V. It must reach %2 V.</source>
        <translation>A alimentação ainda está em %1 V. Tem de atingir %2 V.</translation>
    </message>
    <message>
        <source>The supply is still at %1 V. It must fall to %2 V.</source>
        <translation>A alimentação ainda está em %1 V. Tem de descer até %2 V.</translation>
    </message>
    <message>
        <source>The drive does not report its supply voltage.</source>
        <translation>O acionamento não comunica a tensão de alimentação.</translation>
    </message>
    <message>
        <source>The drive does not report its temperature.</source>
        <translation>O acionamento não comunica a temperatura.</translation>
    </message>
    <message>
        <source>The motor was at %1 °C and no longer reports its temperature. Repair its sensor, or let the motor cool down and restart Boresight.</source>
        <translation>O motor estava a %1 °C e já não comunica a temperatura. Repare o sensor, ou deixe o motor arrefecer e reinicie o Boresight.</translation>
    </message>
    <message>
        <source>the sensor does not report the calibration of its compass</source>
        <translation>o sensor não comunica a calibração da sua bússola</translation>
    </message>
    <message>
        <source>the orientation sensor sends data: %1</source>
        <translation>o sensor de orientação é recebido: %1</translation>
    </message>
    <message>
        <source>the orientation sensor restarted, so its calibration begins again</source>
        <translation>o sensor de orientação reiniciou: a sua calibração recomeça</translation>
    </message>
    <message>
        <source>its messages contain unknown fields: %1</source>
        <translation>as suas mensagens contêm mais do que aqui se conhece: %1</translation>
    </message>
    <message>
        <source>setting the id of board %1 to %2. The old id is %3</source>
        <translation>a definir o id da placa %1 para %2. O id antigo é %3</translation>
    </message>
    <message>
        <source>The limits, speeds and gains of the drive count turns of the axis. Boresight multiplies kp, ki and kd by %1. The motor stays as stiff as before. Press Fix afterwards to write limits and speeds. Boresight asks for the cable wrap again.</source>
        <translation>Os limites, velocidades e ganhos do acionamento contam voltas do eixo. O Boresight multiplica kp, ki e kd por %1. O motor fica tão rígido como antes. Depois prima Corrigir para escrever limites e velocidades. O Boresight volta a perguntar a volta do cabo.</translation>
    </message>
    <message>
        <source>The gains are stored. The drive keeps them after a power cycle.</source>
        <translation>Os ganhos estão guardados. O acionamento mantém-nos depois de desligado e ligado.</translation>
    </message>
    <message>
        <source>The gear ratio of the profile (gear_ratio, gear_in). With another ratio every angle is wrong. Press Set gear to write the ratio of the profile. Boresight also changes the gains.</source>
        <translation>A relação de transmissão do perfil (gear_ratio, gear_in). Com outra relação todos os ângulos estão errados. Prima Definir redução para escrever a relação do perfil. O Boresight altera também os ganhos.</translation>
    </message>
    <message>
        <source>Scan a smaller width, or scan later. Not every place around the %1 is permitted: %2</source>
        <translation>Varra uma largura menor ou mais tarde. Nem todos os lugares à volta do astro (%1) são permitidos: %2</translation>
    </message>
    <message>
        <source>Mode 15 brakes but does not hold. It is right only for a self-locking gearbox (timeout_mode = &quot;brake&quot; in the profile).</source>
        <translation>O modo 15 freia mas não segura. Só é certo para um redutor autoblocante (timeout_mode = &quot;brake&quot; no perfil).</translation>
    </message>
    <message>
        <source>Without current the axis falls. Without a limit the motor burns. The value is in the data sheet of the motor.</source>
        <translation>Sem corrente o eixo cai. Sem limite o motor queima. O valor está na folha de dados do motor.</translation>
    </message>
    <message>
        <source>The operator has control. Press Hand over first.</source>
        <translation>O operador tem o controlo. Prima Entregar primeiro.</translation>
    </message>
    <message>
        <source>The crash-stop test moves the mount. End it first.</source>
        <translation>A prova de paragem move a montagem. Termine-a primeiro.</translation>
    </message>
    <message>
        <source>No crash-stop test is running.</source>
        <translation>Não está a decorrer nenhuma prova de paragem.</translation>
    </message>
    <message>
        <source>crash-stop test at %1°/s</source>
        <translation>prova de paragem a %1°/s</translation>
    </message>
    <message>
        <source>crash-stop test: %1</source>
        <translation>prova de paragem: %1</translation>
    </message>
    <message>
        <source>Wait until the mount stands still.</source>
        <translation>Espere que a montagem pare.</translation>
    </message>
    <message>
        <source>The computed position of the %1 jumped, so tracking stopped. Was the clock or the site changed? Check both, then track the %1 again.</source>
        <translation>A posição calculada do astro (%1) saltou, por isso o seguimento parou. O relógio ou o local foi alterado? Verifique ambos e siga de novo.</translation>
    </message>
    <message>
        <source>%1 is %2, needed %3</source>
        <translation>%1 é %2, necessário %3</translation>
    </message>
    <message>
        <source>a setting of the %1 drive is unsafe: %2</source>
        <translation>uma definição do acionamento de %1 é perigosa: %2</translation>
    </message>
    <message>
        <source>%1 settings of the %2 drive are unsafe. The first: %3</source>
        <translation>%1 definições do acionamento de %2 são perigosas. A primeira: %3</translation>
    </message>
    <message>
        <source>%1 settings of the %2 drive are worth fixing. The first: %3</source>
        <translation>%1 definições do acionamento de %2 merecem correção. A primeira: %3</translation>
    </message>
    <message>
        <source>Open the page Protection and press Fix. For a wrong gear ratio press Set gear.</source>
        <translation>Abra a página Proteção e prima Corrigir. Para uma redução errada prima Definir redução.</translation>
    </message>
    <message>
        <source>The compass and the north in force differ by %1. Their errors do not explain this. If the mount was moved or slipped, press Apply. If iron came near, remove it and measure again.</source>
        <translation>A bússola e o norte em vigor diferem %1. Os erros deles não o explicam. Se a montagem foi movida ou escorregou, prima Aplicar. Se há ferro por perto, afaste-o e meça de novo.</translation>
    </message>
    <message>
        <source>You entered the cable wrap again after the first of these points. If the wrap changed, the points do not fit together. Then drop the older points.</source>
        <translation>A volta do cabo foi indicada de novo depois do primeiro destes pontos. Se a volta mudou, os pontos não condizem. Elimine então os pontos mais antigos.</translation>
    </message>
    <message>
        <source>The antenna stands in a forbidden direction: %1</source>
        <translation>A antena está numa direção proibida: %1</translation>
    </message>
    <message>
        <source>Check the adapter and its cable. If this is the wrong adapter, choose another one in the guide or on the page Profile</source>
        <translation>Verifique o adaptador e o seu cabo. Se este for o adaptador errado, escolha outro no guia ou na página Perfil</translation>
    </message>
    <message>
        <source>Check the adapter and its cable, then press Reconnect. If this is the wrong port, choose another one in the guide</source>
        <translation>Verifique o adaptador e o seu cabo e prima Reconectar. Se esta for a porta errada, escolha outra no guia</translation>
    </message>
    <message>
        <source>The orbit of %1 cannot be computed any more: %2</source>
        <translation>A órbita de %1 já não pode ser calculada: %2</translation>
    </message>
    <message>
        <source>Boresight ended the tracking. The mount holds</source>
        <translation>O Boresight terminou o seguimento. A montagem mantém a posição</translation>
    </message>
    <message>
        <source>Load newer elements of the satellite, then track it again</source>
        <translation>Carregue elementos mais recentes do satélite e siga-o de novo</translation>
    </message>
    <message>
        <source>Element files</source>
        <translation>Ficheiros de elementos</translation>
    </message>
    <message>
        <source>Oldest elements</source>
        <translation>Elementos mais antigos</translation>
    </message>
    <message>
        <source>Lead of the set-points</source>
        <translation>Avanço das referências</translation>
    </message>
    <message>
        <source>The elements of %1 are %2 days old. The setting oldest_days permits %3. Load newer elements.</source>
        <translation>Os elementos de %1 têm %2 dias. O ajuste oldest_days permite %3. Carregue elementos mais recentes.</translation>
    </message>
    <message>
        <source>The orbit of %1 cannot be computed: %2</source>
        <translation>A órbita de %1 não pode ser calculada: %2</translation>
    </message>
    <message>
        <source>%1 does not rise within a day.</source>
        <translation>%1 não nasce dentro de um dia.</translation>
    </message>
    <message>
        <source>%1 rises at %2, in %3. Track it in the last %4 minutes before that.</source>
        <translation>%1 nasce às %2, daqui a %3. Siga-o nos últimos %4 minutos antes disso.</translation>
    </message>
    <message>
        <source>The site of the mount is not set. Enter it in the profile.</source>
        <translation>O local da montagem não está definido. Indique-o no perfil.</translation>
    </message>
    <message>
        <source>track %1</source>
        <translation>seguir %1</translation>
    </message>
    <message>
        <source>ends the tracking, because control was given away</source>
        <translation>termina o seguimento, porque o controlo foi cedido</translation>
    </message>
    <message>
        <source>%1 has set, and the mount holds</source>
        <translation>%1 pôs-se, e a montagem mantém a posição</translation>
    </message>
    <message>
        <source>ends the tracking: %1</source>
        <translation>termina o seguimento: %1</translation>
    </message>
    <message>
        <source>the elements of %1 satellites are read</source>
        <translation>lidos os elementos de %1 satélites</translation>
    </message>
    <message>
        <source>Elevation direction</source>
        <translation>Sentido da elevação</translation>
    </message>
    <message>
        <source>Whether the sensor&apos;s elevation grows (&quot;up&quot;) or falls (&quot;down&quot;) when the beam rises. For a sensor that reports 180° - elevation: &quot;down&quot;, with an elevation offset of 180°.</source>
        <translation>Se a elevação do sensor cresce (&quot;up&quot;) ou diminui (&quot;down&quot;) quando o feixe sobe. Para um sensor que envia 180° - elevação: &quot;down&quot;, com um desvio de elevação de 180°.</translation>
    </message>
    <message>
        <source>The board %1 (id %2) reports fault %3</source>
        <translation>A placa %1 (id %2) comunica a falha %3</translation>
    </message>
    <message>
        <source>Boresight only watches this board</source>
        <translation>O Boresight só observa esta placa</translation>
    </message>
    <message>
        <source>The board %1 (id %2) does not reply</source>
        <translation>A placa %1 (id %2) não responde</translation>
    </message>
    <message>
        <source>The board with the id %1 turns an axis</source>
        <translation>A placa com o id %1 move um eixo</translation>
    </message>
    <message>
        <source>names the id %1 twice</source>
        <translation>indica o id %1 duas vezes</translation>
    </message>
    <message>
        <source>Watched boards</source>
        <translation>Placas observadas</translation>
    </message>
    <message>
        <source>Further moteus boards on the bus, each with its id and a name: &quot;3 polarisation&quot;. Boresight shows what they report. It never commands them.</source>
        <translation>Outras placas moteus no barramento, cada uma com o seu id e um nome: &quot;3 polarização&quot;. O Boresight mostra o que elas comunicam. Nunca as comanda.</translation>
    </message>
    <message>
        <source>the id of a board and its name are expected, like &quot;3 polarisation&quot;</source>
        <translation>esperam-se o id de uma placa e o seu nome, como &quot;3 polarização&quot;</translation>
    </message>
    <message>
        <source>%1 more refused in %2 s. The last: %3</source>
        <translation>%1 outras recusadas em %2 s. A última: %3</translation>
    </message>
    <message>
        <source>The list of satellites is not complete.</source>
        <translation>A lista de satélites não está completa.</translation>
    </message>
    <message>
        <source>tracks %1 from now on</source>
        <translation>segue %1 a partir de agora</translation>
    </message>
    <message>
        <source>The site of the mount was changed. Track the target again.</source>
        <translation>O local da montagem foi alterado. Volte a seguir o alvo.</translation>
    </message>
    <message>
        <source>%1 Take the control first.</source>
        <translation>%1 Tome primeiro o controlo.</translation>
    </message>
    <message>
        <source>The Moon cannot be tracked by azel.dat: %1</source>
        <translation>Não é possível seguir a Lua pelo azel.dat: %1</translation>
    </message>
    <message>
        <source>The mount stands still. It moves again BY ITSELF if the file is right again before %2</source>
        <translation>A montagem está parada. Volta a mover-se POR SI se o ficheiro voltar a estar certo antes das %2</translation>
    </message>
    <message>
        <source>STOP or Hold ends the tracking</source>
        <translation>STOP ou Manter termina o seguimento</translation>
    </message>
    <message>
        <source>The Moon is no longer tracked by azel.dat: %1</source>
        <translation>A Lua já não é seguida pelo azel.dat: %1</translation>
    </message>
    <message>
        <source>Enter the same locator in WSJT-X and in the profile, with at least six characters</source>
        <translation>Introduza o mesmo localizador no WSJT-X e no perfil, com pelo menos seis caracteres</translation>
    </message>
    <message>
        <source>the file was not read yet</source>
        <translation>o ficheiro ainda não foi lido</translation>
    </message>
    <message>
        <source>the time in the file and the clock of this computer differ by %1 s</source>
        <translation>a hora no ficheiro e o relógio deste computador diferem %1 s</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>o ficheiro está vazio</translation>
    </message>
    <message>
        <source>the file is cut: the line of the Sun or of the Doppler is missing</source>
        <translation>o ficheiro está cortado: falta a linha do Sol ou do Doppler</translation>
    </message>
    <message>
        <source>the time of the Moon cannot be read</source>
        <translation>não é possível ler a hora da Lua</translation>
    </message>
    <message>
        <source>the angles of the Moon cannot be read or are out of range</source>
        <translation>os ângulos da Lua não são legíveis ou estão fora dos limites</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>esse ficheiro não existe</translation>
    </message>
    <message>
        <source>Mercury</source>
        <translation>Mercúrio</translation>
    </message>
    <message>
        <source>Venus</source>
        <translation>Vénus</translation>
    </message>
    <message>
        <source>Mars</source>
        <translation>Marte</translation>
    </message>
    <message>
        <source>Jupiter</source>
        <translation>Júpiter</translation>
    </message>
    <message>
        <source>Saturn</source>
        <translation>Saturno</translation>
    </message>
    <message>
        <source>Uranus</source>
        <translation>Úrano</translation>
    </message>
    <message>
        <source>Neptune</source>
        <translation>Neptuno</translation>
    </message>
    <message>
        <source>azel.dat</source>
        <translation>azel.dat</translation>
    </message>
    <message>
        <source>The file by which WSJT-X, MAP65 or QMAP report the Moon. Empty: azel.dat in the folder of WSJT-X of this user.</source>
        <translation>O ficheiro pelo qual o WSJT-X, o MAP65 ou o QMAP indicam a Lua. Vazio: o azel.dat na pasta do WSJT-X deste utilizador.</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>Part of the beam width</source>
        <translation>Parte da largura do feixe</translation>
    </message>
    <message>
        <source>Move only while receiving</source>
        <translation>Mover só na receção</translation>
    </message>
    <message>
        <source>it does not show whether the radio transmits, and the setting only_while_receiving is on</source>
        <translation>não indica se o rádio transmite, e a definição only_while_receiving está ligada</translation>
    </message>
    <message>
        <source>azel.dat cannot be used: %1</source>
        <translation>não é possível usar o azel.dat: %1</translation>
    </message>
    <message>
        <source>track the Moon by WSJT-X</source>
        <translation>seguir a Lua pelo WSJT-X</translation>
    </message>
    <message>
        <source>park at %1, because the Moon is below the horizon</source>
        <translation>estacionar em %1, porque a Lua está abaixo do horizonte</translation>
    </message>
    <message>
        <source>Moon (WSJT-X)</source>
        <translation>Lua (WSJT-X)</translation>
    </message>
    <message>
        <source>A direction is &quot;azel AZIMUTH,ELEVATION&quot; in degrees, like &quot;azel 120.5,30&quot;.</source>
        <translation>Uma direção é &quot;azel AZIMUTE,ELEVAÇÃO&quot; em graus, como &quot;azel 120.5,30&quot;.</translation>
    </message>
    <message>
        <source>A place among the stars is &quot;radec HOURS,DEGREES&quot; of J2000, like &quot;radec 12:30:49.4,12:23:28&quot; or &quot;radec 12.514,12.391&quot;.</source>
        <translation>Um lugar entre as estrelas é &quot;radec HORAS,GRAUS&quot; de J2000, como &quot;radec 12:30:49.4,12:23:28&quot; ou &quot;radec 12.514,12.391&quot;.</translation>
    </message>
    <message>
        <source>RA %1 h, declination %2</source>
        <translation>AR %1 h, declinação %2</translation>
    </message>
    <message>
        <source>A position is &quot;place NORTH,EAST,HEIGHT&quot; in degrees and metres, like &quot;place 38.757,-9.117,1200&quot;. The height may be left out.</source>
        <translation>Uma posição é &quot;place NORTE,ESTE,ALTURA&quot; em graus e metros, como &quot;place 38.757,-9.117,1200&quot;. A altura pode ser omitida.</translation>
    </message>
    <message>
        <source>%1 north, %2 east</source>
        <translation>%1 norte, %2 este</translation>
    </message>
    <message>
        <source>%1, long path</source>
        <translation>%1, caminho longo</translation>
    </message>
    <message>
        <source>The schedule of passes is off: %1</source>
        <translation>A agenda de passagens está desligada: %1</translation>
    </message>
    <message>
        <source>Boresight begins no further pass by itself</source>
        <translation>O Boresight não começa mais nenhuma passagem sozinho</translation>
    </message>
    <message>
        <source>Arm the schedule again when the mount may move by itself</source>
        <translation>Arme a agenda de novo quando a montagem puder mover-se sozinha</translation>
    </message>
    <message>
        <source>schedule</source>
        <translation>agenda</translation>
    </message>
    <message>
        <source>arms the schedule of passes</source>
        <translation>arma a agenda de passagens</translation>
    </message>
    <message>
        <source>%1 disarmed it</source>
        <translation>%1 desarmou-a</translation>
    </message>
    <message>
        <source>The watch list of the profile is empty.</source>
        <translation>A lista de satélites da agenda no perfil está vazia.</translation>
    </message>
    <message>
        <source>A calibration or a tuning run moves the mount. End it first.</source>
        <translation>Uma calibração ou um ensaio de sintonia move a montagem. Termine-o primeiro.</translation>
    </message>
    <message>
        <source>the schedule is off: %1</source>
        <translation>a agenda está desligada: %1</translation>
    </message>
    <message>
        <source>STOP of %1</source>
        <translation>STOP de %1</translation>
    </message>
    <message>
        <source>a fault ended the motion</source>
        <translation>uma falha terminou o movimento</translation>
    </message>
    <message>
        <source>the mount does not answer</source>
        <translation>a montagem não responde</translation>
    </message>
    <message>
        <source>control was given to the clients</source>
        <translation>o controlo foi dado aos clientes</translation>
    </message>
    <message>
        <source>another command moved the mount</source>
        <translation>outro comando moveu a montagem</translation>
    </message>
    <message>
        <source>no elements of %1</source>
        <translation>não há elementos de %1</translation>
    </message>
    <message>
        <source>the site of the mount is not set</source>
        <translation>o local da montagem não está definido</translation>
    </message>
    <message>
        <source>The elements of %1 are gone.</source>
        <translation>Já não há elementos de %1.</translation>
    </message>
    <message>
        <source>goes to the pass of %1 at %2</source>
        <translation>vai para a passagem de %1 às %2</translation>
    </message>
    <message>
        <source>the pass of %1 is left out: %2</source>
        <translation>a passagem de %1 fica de fora: %2</translation>
    </message>
    <message>
        <source>Satellite</source>
        <translation>Satélite</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Prioridade</translation>
    </message>
    <message>
        <source>1 is the most important.</source>
        <translation>1 é a mais importante.</translation>
    </message>
    <message>
        <source>Passes that overlap</source>
        <translation>Passagens sobrepostas</translation>
    </message>
    <message>
        <source>In place before a pass</source>
        <translation>No lugar antes de uma passagem</translation>
    </message>
    <message>
        <source>The schedule sends the mount to the beginning of a pass this long before it.</source>
        <translation>A agenda manda a montagem para o início de uma passagem este tempo antes dela.</translation>
    </message>
    <message>
        <source>Between passes</source>
        <translation>Entre passagens</translation>
    </message>
    <message>
        <source>Park after the passes</source>
        <translation>Estacionar depois das passagens</translation>
    </message>
    <message>
        <source>Whether the schedule parks the mount when no pass follows for half an hour.</source>
        <translation>Se a agenda estaciona a montagem quando não há outra passagem durante meia hora.</translation>
    </message>
    <message>
        <source>Unattended</source>
        <translation>Sem operador</translation>
    </message>
    <message>
        <source>is needed</source>
        <translation>é necessário</translation>
    </message>
    <message>
        <source>is in the list twice</source>
        <translation>está duas vezes na lista</translation>
    </message>
    <message>
        <source>%1: refused. %2</source>
        <translation>%1: recusado. %2</translation>
    </message>
    <message>
        <source>Boresight was closed</source>
        <translation>O Boresight foi fechado</translation>
    </message>
    <message>
        <source>The night report could not be written: %1</source>
        <translation>Não foi possível escrever o relatório da noite: %1</translation>
    </message>
    <message>
        <source>armed by the profile (schedule.unattended)</source>
        <translation>armada pelo perfil (schedule.unattended)</translation>
    </message>
    <message>
        <source>The stored night report cannot be read: %1. The new report is kept in memory only.</source>
        <translation>O relatório da noite guardado não pode ser lido: %1. O novo relatório fica só na memória.</translation>
    </message>
    <message>
        <source>The stored calibrations cannot be read: %1</source>
        <translation>As calibrações guardadas não se leem: %1</translation>
    </message>
    <message>
        <source>the drive of %1 was late: no reply for %2 (limit %3)</source>
        <translation>o acionamento do %1 atrasou-se: nenhuma resposta durante %2 (limite %3)</translation>
    </message>
    <message>
        <source>The schedule has no pass within a day.</source>
        <translation>A agenda não tem nenhuma passagem nas próximas 24 horas.</translation>
    </message>
    <message>
        <source>The rehearsal was stopped.</source>
        <translation>O ensaio foi parado.</translation>
    </message>
    <message>
        <source>A rehearsal runs already. Wait for its end, or stop it.</source>
        <translation>Já decorre um ensaio. Espere pelo fim, ou pare-o.</translation>
    </message>
    <message>
        <source>The clock of this computer is not synchronised, so the beam may miss %1</source>
        <translation>O relógio deste computador não está sincronizado, por isso o feixe pode falhar %1</translation>
    </message>
    <message>
        <source>This computer was suspended for %1 s</source>
        <translation>Este computador esteve suspenso durante %1 s</translation>
    </message>
    <message>
        <source>Boresight commanded nothing meanwhile. Drives that were moving stopped by their own watchdog</source>
        <translation>O Boresight nada comandou entretanto. Os controladores em movimento pararam pelo próprio watchdog</translation>
    </message>
    <message>
        <source>Look at the mount. Switch off the suspend of this computer</source>
        <translation>Olhe para a montagem. Desligue a suspensão deste computador</translation>
    </message>
    <message>
        <source>The clock of this computer was set by %1 s</source>
        <translation>O relógio deste computador foi acertado em %1 s</translation>
    </message>
    <message>
        <source>Check the time source if this was not expected</source>
        <translation>Verifique a fonte de tempo se isto não era esperado</translation>
    </message>
    <message>
        <source>this computer was suspended for %1 s</source>
        <translation>este computador esteve suspenso durante %1 s</translation>
    </message>
    <message>
        <source>plans the passes again, because the clock of this computer was set back by %1 s</source>
        <translation>planeia as passagens de novo, porque o relógio deste computador foi atrasado %1 s</translation>
    </message>
    <message>
        <source>the clock of this computer was set back</source>
        <translation>o relógio deste computador foi atrasado</translation>
    </message>
    <message>
        <source>AOS of %1</source>
        <translation>AOS de %1</translation>
    </message>
    <message>
        <source>the pass of %1 begins at %2</source>
        <translation>a passagem de %1 começa às %2</translation>
    </message>
    <message>
        <source>LOS of %1</source>
        <translation>LOS de %1</translation>
    </message>
    <message>
        <source>the pass of %1 ends before its LOS</source>
        <translation>a passagem de %1 acaba antes do seu LOS</translation>
    </message>
    <message>
        <source>texts of one line, of at most 1000 bytes, are expected</source>
        <translation>esperam-se textos de uma linha, com 1000 bytes no máximo</translation>
    </message>
    <message>
        <source>the path of a program from / on is expected first</source>
        <translation>espera-se primeiro o caminho de um programa a partir de /</translation>
    </message>
    <message>
        <source>Program before AOS</source>
        <translation>Programa antes do AOS</translation>
    </message>
    <message>
        <source>A program with its arguments that runs before a pass of the armed schedule. Its path begins with /. There is no shell. Empty: none.</source>
        <translation>Um programa com os seus argumentos, que corre antes de uma passagem da agenda armada. O seu caminho começa por /. Não há shell. Vazio: nenhum.</translation>
    </message>
    <message>
        <source>Time before AOS</source>
        <translation>Tempo antes do AOS</translation>
    </message>
    <message>
        <source>Program at AOS</source>
        <translation>Programa no AOS</translation>
    </message>
    <message>
        <source>Program at LOS</source>
        <translation>Programa no LOS</translation>
    </message>
    <message>
        <source>Program at a fault</source>
        <translation>Programa numa falha</translation>
    </message>
    <message>
        <source>%1 was not started: %2 programs run already</source>
        <translation>%1 não foi iniciado: já correm %2 programas</translation>
    </message>
    <message>
        <source>could not be started: %1</source>
        <translation>não pôde ser iniciado: %1</translation>
    </message>
    <message>
        <source>ended after %1 s</source>
        <translation>acabou ao fim de %1 s</translation>
    </message>
    <message>
        <source>was ended after %1 s, the longest time for a program</source>
        <translation>foi terminado ao fim de %1 s, o tempo máximo de um programa</translation>
    </message>
    <message>
        <source>crashed after %1 s</source>
        <translation>falhou ao fim de %1 s</translation>
    </message>
    <message>
        <source>ended with status %1 after %2 s</source>
        <translation>acabou com o estado %1 ao fim de %2 s</translation>
    </message>
    <message>
        <source>%1: this folder cannot be made</source>
        <translation>%1: não é possível criar esta pasta</translation>
    </message>
    <message>
        <source>The server has sent nothing for %1 s.</source>
        <translation>O servidor não envia nada há %1 s.</translation>
    </message>
    <message>
        <source>The download has taken more than %1 minutes.</source>
        <translation>A transferência demorou mais de %1 minutos.</translation>
    </message>
    <message>
        <source>The answer is larger than %1 MB.</source>
        <translation>A resposta é maior do que %1 MB.</translation>
    </message>
    <message>
        <source>No network, or no server %1.</source>
        <translation>Sem rede, ou não há servidor %1.</translation>
    </message>
    <message>
        <source>The download has failed: %1.</source>
        <translation>A transferência falhou: %1.</translation>
    </message>
    <message>
        <source>The server answers %1.</source>
        <translation>O servidor responde %1.</translation>
    </message>
    <message>
        <source>The answer is empty.</source>
        <translation>A resposta está vazia.</translation>
    </message>
    <message>
        <source>The answer has no element set. It begins with &quot;%1&quot;.</source>
        <translation>A resposta não tem elementos orbitais. Começa por &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>The answer is cut or damaged. Line %1: %2</source>
        <translation>A resposta está cortada ou danificada. Linha %1: %2</translation>
    </message>
    <message>
        <source>The answer cannot be stored: %1.</source>
        <translation>Não é possível guardar a resposta: %1.</translation>
    </message>
    <message>
        <source>The cache cannot be written, so nothing is downloaded: %1.</source>
        <translation>Não é possível escrever na cache, por isso nada é transferido: %1.</translation>
    </message>
    <message>
        <source>Elements of %1 from the cache are used.</source>
        <translation>São usados os elementos de %1 que estão na cache.</translation>
    </message>
    <message>
        <source>Next download: %1.</source>
        <translation>Próxima transferência: %1.</translation>
    </message>
    <message>
        <source>CelesTrak group %1</source>
        <translation>Grupo %1 do CelesTrak</translation>
    </message>
    <message>
        <source>a path from / on, an address that begins with https://, or celestrak:GROUP is expected</source>
        <translation>espera-se um caminho a partir de /, um endereço que comece por https:// ou celestrak:GRUPO</translation>
    </message>
    <message>
        <source>Files, folders and https addresses with the orbital elements of satellites: TLE, or OMM as JSON, CSV, XML or KVN. celestrak:stations is a group of CelesTrak. Empty: the satellites of Gpredict on this computer.</source>
        <translation>Ficheiros, pastas e endereços https com os elementos orbitais de satélites: TLE, ou OMM em JSON, CSV, XML ou KVN. celestrak:stations é um grupo do CelesTrak. Vazio: os satélites do Gpredict deste computador.</translation>
    </message>
    <message>
        <source>%1 further problems with the elements of satellites</source>
        <translation>mais %1 problemas com os elementos dos satélites</translation>
    </message>
    <message>
        <source>the clock of this computer was set by %1 s</source>
        <translation>o relógio deste computador foi acertado em %1 s</translation>
    </message>
    <message>
        <source>one turn less</source>
        <translation>uma volta a menos</translation>
    </message>
    <message>
        <source>one turn more</source>
        <translation>uma volta a mais</translation>
    </message>
    <message>
        <source>%1 turns less</source>
        <translation>%1 voltas a menos</translation>
    </message>
    <message>
        <source>%1 turns more</source>
        <translation>%1 voltas a mais</translation>
    </message>
    <message>
        <source>%1 (the same direction)</source>
        <translation>%1 (a mesma direção)</translation>
    </message>
    <message>
        <source>az %1 (%2)</source>
        <translation>az %1 (%2)</translation>
    </message>
    <message>
        <source>trims the tracked target by %1 in azimuth, %2 in elevation</source>
        <translation>compensa o alvo seguido em %1 de azimute, %2 de elevação</translation>
    </message>
    <message>
        <source>point %1: %2 at %3. The axes stand at %4.</source>
        <translation>ponto %1: %2 em %3. Os eixos estão em %4.</translation>
    </message>
    <message>
        <source>The %1 was silent for %2 and is back</source>
        <translation>O %1 esteve em silêncio durante %2 e voltou</translation>
    </message>
    <message>
        <source>Boresight ended the motion. %3</source>
        <translation>O Boresight terminou o movimento. %3</translation>
    </message>
    <message>
        <source>Neither drive replies</source>
        <translation>Nenhum dos acionamentos responde</translation>
    </message>
    <message>
        <source>Boresight ended the motion. If the drives have power, their watchdog brakes them after %1 s</source>
        <translation>O Boresight terminou o movimento. Se os acionamentos têm energia, o seu watchdog trava-os ao fim de %1 s</translation>
    </message>
    <message>
        <source>Both drives were silent for %1 and are back</source>
        <translation>Os dois acionamentos estiveram em silêncio durante %1 e voltaram</translation>
    </message>
    <message>
        <source>Boresight ended the motion. %2</source>
        <translation>O Boresight terminou o movimento. %2</translation>
    </message>
    <message>
        <source>Nothing moves before a re-arm</source>
        <translation>Nada se move antes de rearmar</translation>
    </message>
    <message>
        <source>Check the supply, the CAN cable, the adapter and the ids of the drives. The page Drives lists the drives</source>
        <translation>Verifique a alimentação, o cabo CAN, o adaptador e os ids dos acionamentos. A página Acionamentos lista os acionamentos</translation>
    </message>
    <message>
        <source>compass swing, to a heading</source>
        <translation>giro da bússola, para um rumo</translation>
    </message>
    <message>
        <source>compass swing, to its start</source>
        <translation>giro da bússola, para o início</translation>
    </message>
    <message>
        <source>compass swing, turning clockwise</source>
        <translation>giro da bússola, a girar no sentido horário</translation>
    </message>
    <message>
        <source>compass swing, turning counter-clockwise</source>
        <translation>giro da bússola, a girar no sentido anti-horário</translation>
    </message>
    <message>
        <source>compass swing, waiting for sensor data</source>
        <translation>giro da bússola, à espera de dados do sensor</translation>
    </message>
    <message>
        <source>tuning run, to its start</source>
        <translation>ensaio de afinação, para o início</translation>
    </message>
    <message>
        <source>Look for what blocks the axis: a cable, a lock, ice or a coupling. Free the axis.</source>
        <translation>Procure o que bloqueia o eixo: um cabo, um trinco, gelo ou um acoplamento. Liberte o eixo.</translation>
    </message>
    <message>
        <source>Check WSJT-X, then track the Moon again</source>
        <translation>Verifique o WSJT-X e depois siga de novo a Lua</translation>
    </message>
    <message>
        <source>The file is not an azel.dat. It is longer than %1 bytes.</source>
        <translation>O ficheiro não é um azel.dat. Tem mais de %1 bytes.</translation>
    </message>
    <message>
        <source>The file is not an azel.dat. It has characters that are not plain text.</source>
        <translation>O ficheiro não é um azel.dat. Tem caracteres que não são texto simples.</translation>
    </message>
    <message>
        <source>The file has no line for the Moon.</source>
        <translation>O ficheiro não tem uma linha para a Lua.</translation>
    </message>
    <message>
        <source>The file is half written. Moon and Sun have different times.</source>
        <translation>O ficheiro está escrito só em parte. A Lua e o Sol têm horas diferentes.</translation>
    </message>
    <message>
        <source>no board acknowledges the frames: check the power of the drives, the cable, the 120 ohm at both ends and the bit rate</source>
        <translation>nenhuma placa confirma as tramas: verifique a alimentação dos acionamentos, o cabo, os 120 ohm nas duas pontas e a taxa de bits</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a catalogue number.</source>
        <translation>%1: &quot;%2&quot; não é um número de catálogo.</translation>
    </message>
    <message>
        <source>%1 is not a folder of this user</source>
        <translation>%1 não é uma pasta deste utilizador</translation>
    </message>
    <message>
        <source>There is nothing to clear. The limit ends when the load falls</source>
        <translation>Não há nada a limpar. O limite termina quando a carga baixar</translation>
    </message>
    <message>
        <source>Wait until the axis stands still and re-arm. If the fault returns, replace the board</source>
        <translation>Espere até o eixo ficar parado e rearme. Se a falha voltar, substitua a placa</translation>
    </message>
    <message>
        <source>Use a stronger supply or lower the drive&apos;s maximum power or current. If the fault returns, read drv8323 with tview and replace the board</source>
        <translation>Use uma alimentação mais forte ou baixe a potência ou corrente máxima do acionamento. Se a falha voltar, leia drv8323 com tview e substitua a placa</translation>
    </message>
    <message>
        <source>Braking energy went into the supply. The supply could not absorb it</source>
        <translation>A energia da travagem foi para a alimentação. A alimentação não a conseguiu absorver</translation>
    </message>
    <message>
        <source>There is nothing to clear. Check the supply if it is below its nominal voltage</source>
        <translation>Não há nada a limpar. Verifique a alimentação se estiver abaixo da tensão nominal</translation>
    </message>
    <message>
        <source>There is nothing to clear. Move the other way or correct the bounds</source>
        <translation>Não há nada a limpar. Mova para o outro lado ou corrija os limites</translation>
    </message>
    <message>
        <source>The drive weakens the field to reach the speed</source>
        <translation>O acionamento enfraquece o campo para atingir a velocidade</translation>
    </message>
    <message>
        <source>Compare the firmware version of the drive with the version that this program was made for</source>
        <translation>Compare a versão do firmware do acionamento com a versão para que este programa foi feito</translation>
    </message>
    <message>
        <source>no commands to the %1, measuring how it stops</source>
        <translation>sem comandos ao %1, a medir como para</translation>
    </message>
    <message>
        <source>The drive check interrupted the reading. Read the gains again.</source>
        <translation>A verificação dos acionamentos interrompeu a leitura. Leia de novo os ganhos.</translation>
    </message>
    <message>
        <source>This computer does not know the authority of its certificate. Set mqtt.ca_file</source>
        <translation>Este computador não conhece a autoridade do certificado. Defina mqtt.ca_file</translation>
    </message>
    <message>
        <source>The station ended the tracking. The log shows the reason</source>
        <translation>A estação terminou o seguimento. O registo mostra o motivo</translation>
    </message>
    <message>
        <source>Angle by which the beam is not perpendicular to the elevation axis. Clockwise is positive, at any elevation.</source>
        <translation>Ângulo que falta ao feixe para ser perpendicular ao eixo de elevação. O sentido horário é positivo, em qualquer elevação.</translation>
    </message>
    <message>
        <source>Axes not perpendicular</source>
        <translation>Eixos não perpendiculares</translation>
    </message>
    <message>
        <source>Angle by which the two axes are not perpendicular. With a positive angle a raised beam points clockwise.</source>
        <translation>Ângulo que falta para os dois eixos serem perpendiculares. Com um ângulo positivo, um feixe levantado aponta no sentido horário.</translation>
    </message>
    <message>
        <source>UDP: the address of this computer to listen on. 127.0.0.1 receives from this computer only, 0.0.0.0 from all computers. TCP: name or address of the computer with the receiver.</source>
        <translation>UDP: o endereço deste computador em que escutar. 127.0.0.1 recebe só deste computador, 0.0.0.0 de todos os computadores. TCP: nome ou endereço do computador com o recetor.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address like 192.168.1.7 or ::1</source>
        <translation>&quot;%1&quot; não é um endereço como 192.168.1.7 ou ::1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a network like 10.0.0.0/8 or fd00::/8</source>
        <translation>&quot;%1&quot; não é uma rede como 10.0.0.0/8 ou fd00::/8</translation>
    </message>
    <message>
        <source>True headings at which steel disturbs the compass, clockwise, for example &quot;40-80, 350-20&quot;. Boresight does not use its azimuth there. Empty: none.</source>
        <translation>Rumos verdadeiros em que o aço perturba a bússola, no sentido horário, por exemplo &quot;40-80, 350-20&quot;. O Boresight não usa aí o seu azimute. Vazio: nenhum.</translation>
    </message>
    <message>
        <source>The highest speed of the axis.</source>
        <translation>A velocidade mais alta do eixo.</translation>
    </message>
    <message>
        <source>Warn when the last reply of a drive is older than this.</source>
        <translation>Avisar quando a última resposta de um acionamento é mais antiga do que isto.</translation>
    </message>
    <message>
        <source>Boresight cannot read all drives. It tries again every 2 s.</source>
        <translation>O Boresight não consegue ler todos os acionamentos. Tenta de novo a cada 2 s.</translation>
    </message>
    <message>
        <source>The board of %1 has the register map %2. Boresight supports only version %3</source>
        <translation>A placa de %1 tem o mapa de registos %2. O Boresight só suporta a versão %3</translation>
    </message>
    <message>
        <source>The board of %1 reports no register map. Boresight supports only version %2</source>
        <translation>A placa de %1 não indica um mapa de registos. O Boresight só suporta a versão %2</translation>
    </message>
    <message>
        <source>The profile has this id for this axis.</source>
        <translation>O perfil tem este id para este eixo.</translation>
    </message>
    <message>
        <source>With the other sign the axis turns the other way. Then change the sign in the profile, too.</source>
        <translation>Com o outro sinal o eixo gira para o outro lado. Mude então também o sinal no perfil.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a known satellite, a body or a locator. The bodies are: %2.</source>
        <translation>&quot;%1&quot; não é um satélite conhecido, um corpo nem um localizador. Os corpos são: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the name of a CelesTrak group. An example is celestrak:stations</source>
        <translation>&quot;%1&quot; não é o nome de um grupo CelesTrak. Um exemplo é celestrak:stations</translation>
    </message>
    <message>
        <source>%1 satellites are missing there. They keep the elements that were read before.</source>
        <translation>Faltam lá %1 satélites. Mantêm os elementos lidos antes.</translation>
    </message>
    <message>
        <source>the profile keeps the beam away from the Sun. If feed and receiver withstand the Sun, switch sun.keep_away off first.</source>
        <translation>o perfil mantém o feixe longe do Sol. Se o alimentador e o recetor suportam o Sol, desligue primeiro sun.keep_away.</translation>
    </message>
    <message>
        <source>The server redirects more than %1 times.</source>
        <translation>O servidor redireciona mais de %1 vezes.</translation>
    </message>
    <message>
        <source>The server redirects to %1. Only https:// is accepted.</source>
        <translation>O servidor redireciona para %1. Só https:// é aceite.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not begin with https://. Without https others could change the elements on the way</source>
        <translation>&quot;%1&quot; não começa por https://. Sem https, outros poderiam alterar os elementos pelo caminho</translation>
    </message>
    <message>
        <source>%1 does not exist. Plug the adapter in. The command ls /dev/serial/by-id lists all adapters</source>
        <translation>%1 não existe. Ligue o adaptador. O comando ls /dev/serial/by-id mostra todos os adaptadores</translation>
    </message>
    <message>
        <source>The drive has no limit of its own. Only Boresight ends a motion.</source>
        <translation>O acionamento não tem limite próprio. Só o Boresight termina um movimento.</translation>
    </message>
    <message>
        <source>The drive stops the axis here by itself, a little beyond the travel.</source>
        <translation>Aqui o acionamento para o eixo por si próprio, um pouco além do curso.</translation>
    </message>
    <message>
        <source>Mode 12 only damps. Without commands a loaded elevation creeps down.</source>
        <translation>O modo 12 só amortece. Sem comandos, uma elevação com carga desce devagar.</translation>
    </message>
    <message>
        <source>Mode 0 switches the motor off. Without commands the axis is free.</source>
        <translation>O modo 0 desliga o motor. Sem comandos, o eixo fica solto.</translation>
    </message>
    <message>
        <source>This mode is not safe for a drive without commands.</source>
        <translation>Este modo não é seguro para um acionamento sem comandos.</translation>
    </message>
    <message>
        <source>Without commands the drive brakes by itself, then holds.</source>
        <translation>Sem comandos, o acionamento trava por si próprio e depois mantém a posição.</translation>
    </message>
    <message>
        <source>Without commands the drive brakes by itself.</source>
        <translation>Sem comandos, o acionamento trava por si próprio.</translation>
    </message>
    <message>
        <source>After this time without a command the drive stops by itself.</source>
        <translation>Após este tempo sem comandos, o acionamento para por si próprio.</translation>
    </message>
    <message>
        <source>Timeout mode 12 damps with this torque.</source>
        <translation>O modo 12 de tempo esgotado amortece com este binário.</translation>
    </message>
    <message>
        <source>Above this voltage the drive stops, so that braking energy cannot destroy the board.</source>
        <translation>Acima desta tensão o acionamento para, para que a energia de travagem não destrua a placa.</translation>
    </message>
    <message>
        <source>The profile trusts the position after power-up (power_up_position), but the drive has no encoder on the axis.</source>
        <translation>O perfil confia na posição após ligar (power_up_position), mas o acionamento não tem encoder no eixo.</translation>
    </message>
    <message>
        <source>-1: the drive has no encoder on the axis. After power-up the cable wrap is unknown.</source>
        <translation>-1: o acionamento não tem encoder no eixo. Após ligar, a volta do cabo é desconhecida.</translation>
    </message>
    <message>
        <source>With a larger position error the drive stops with fault 49. This protects a blocked axis even without Boresight.</source>
        <translation>Com um erro de posição maior, o acionamento para com a falha 49. Isto protege um eixo bloqueado mesmo sem o Boresight.</translation>
    </message>
    <message>
        <source>With a small value the wind can push the axis away.</source>
        <translation>Com um valor pequeno, o vento pode empurrar o eixo.</translation>
    </message>
    <message>
        <source>Hold at end</source>
        <translation>Parar no fim</translation>
    </message>
    <message>
        <source>Press Unwrap now to choose the moment, then hand control back to the clients. Or press Hold at end to wait there</source>
        <translation>Prima Desenrolar já para escolher o momento e depois devolva o controlo aos clientes. Ou prima Parar no fim para esperar aí</translation>
    </message>
    <message>
        <source>No unwrapping is ahead. There is nothing to choose.</source>
        <translation>Não há desenrolamento à vista. Não há nada a escolher.</translation>
    </message>
    <message>
        <source>the cable ends at axis %1, and the operator chose to hold there</source>
        <translation>o cabo termina no eixo %1, e o operador escolheu parar aí</translation>
    </message>
    <message>
        <source>chooses to hold at the cable end instead of unwrapping</source>
        <translation>escolhe parar no fim do cabo em vez de desenrolar</translation>
    </message>
    <message>
        <source>a text of one line, of at most %1 characters, is expected</source>
        <translation>espera-se um texto de uma linha, com no máximo %1 caracteres</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorito</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the whole path of a file. It must begin with /.</source>
        <translation>&quot;%1&quot; não é o caminho completo de um ficheiro. Tem de começar por /.</translation>
    </message>
    <message>
        <source>Another command came before the file was read. Track it again.</source>
        <translation>Chegou outro comando antes de o ficheiro ser lido. Siga-o outra vez.</translation>
    </message>
    <message>
        <source>The file is larger than %1 MB. Split it.</source>
        <translation>O ficheiro tem mais de %1 MB. Divida-o.</translation>
    </message>
    <message>
        <source>The %1 &quot;%2&quot; is not a number of degrees.</source>
        <translation>%1: &quot;%2&quot; não é um número de graus.</translation>
    </message>
    <message>
        <source>The %1 is %2°. It must be from -%3° to %3°.</source>
        <translation>%1: o valor é %2°. Tem de estar entre -%3° e %3°.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time. A row is a time in UTC like 2024-05-10T04:50:02Z or in Unix seconds, an azimuth and an elevation.</source>
        <translation>&quot;%1&quot; não é uma hora. Uma linha tem uma hora em UTC como 2024-05-10T04:50:02Z ou em segundos Unix, um azimute e uma elevação.</translation>
    </message>
    <message>
        <source>The row has no elevation. A row is a time, an azimuth and an elevation.</source>
        <translation>A linha não tem elevação. Uma linha tem uma hora, um azimute e uma elevação.</translation>
    </message>
    <message>
        <source>The table has more than %1 rows. Split it.</source>
        <translation>A tabela tem mais de %1 linhas. Divida-a.</translation>
    </message>
    <message>
        <source>The row has no other row within an hour. Add rows.</source>
        <translation>A linha não tem outra linha a menos de uma hora. Acrescente linhas.</translation>
    </message>
    <message>
        <source>There is no row. A row is a time, an azimuth and an elevation.</source>
        <translation>Não há nenhuma linha. Uma linha tem uma hora, um azimute e uma elevação.</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; is not one of an OEM.</source>
        <translation>A chave &quot;%1&quot; não pertence a um OEM.</translation>
    </message>
    <message>
        <source>The key %1 is missing above.</source>
        <translation>Falta acima a chave %1.</translation>
    </message>
    <message>
        <source>The centre is &quot;%1&quot;. Boresight reads only orbits with CENTER_NAME = EARTH.</source>
        <translation>O centro é &quot;%1&quot;. O Boresight só lê órbitas com CENTER_NAME = EARTH.</translation>
    </message>
    <message>
        <source>The time system is &quot;%1&quot;. Boresight reads UTC, TAI, GPS and TT.</source>
        <translation>O sistema de tempo é &quot;%1&quot;. O Boresight lê UTC, TAI, GPS e TT.</translation>
    </message>
    <message>
        <source>The frame is &quot;%1&quot;. Boresight reads ITRF, EME2000, GCRF, ICRF, TEME and TOD.</source>
        <translation>O referencial é &quot;%1&quot;. O Boresight lê ITRF, EME2000, GCRF, ICRF, TEME e TOD.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;. It must be a time like 2024-05-10T04:50:02.5.</source>
        <translation>%1 é &quot;%2&quot;. Tem de ser uma hora como 2024-05-10T04:50:02.5.</translation>
    </message>
    <message>
        <source>INTERPOLATION_DEGREE is &quot;%1&quot;. It must be a number from 1 to %2.</source>
        <translation>INTERPOLATION_DEGREE é &quot;%1&quot;. Tem de ser um número de 1 a %2.</translation>
    </message>
    <message>
        <source>After COVARIANCE_STOP only META_START may follow.</source>
        <translation>Depois de COVARIANCE_STOP só pode vir META_START.</translation>
    </message>
    <message>
        <source>An OEM begins with CCSDS_OEM_VERS.</source>
        <translation>Um OEM começa por CCSDS_OEM_VERS.</translation>
    </message>
    <message>
        <source>The version &quot;%1&quot; of OEM is not known. Boresight reads the versions 1 to 3.</source>
        <translation>A versão &quot;%1&quot; de OEM não é conhecida. O Boresight lê as versões 1 a 3.</translation>
    </message>
    <message>
        <source>The file has more than %1 rows. Split it.</source>
        <translation>O ficheiro tem mais de %1 linhas. Divida-o.</translation>
    </message>
    <message>
        <source>The segment that ends here has fewer than two rows.</source>
        <translation>O segmento que acaba aqui tem menos de duas linhas.</translation>
    </message>
    <message>
        <source>The segment that ends here has no rows in its usable time. Correct USEABLE_START_TIME and USEABLE_STOP_TIME.</source>
        <translation>O segmento que acaba aqui não tem linhas no seu tempo utilizável. Corrija USEABLE_START_TIME e USEABLE_STOP_TIME.</translation>
    </message>
    <message>
        <source>The file is cut: COVARIANCE_STOP is missing.</source>
        <translation>O ficheiro está cortado: falta COVARIANCE_STOP.</translation>
    </message>
    <message>
        <source>The file is cut: META_STOP is missing.</source>
        <translation>O ficheiro está cortado: falta META_STOP.</translation>
    </message>
    <message>
        <source>The file has no META_START and no rows.</source>
        <translation>O ficheiro não tem META_START nem linhas.</translation>
    </message>
    <message>
        <source>The speed is %1 km/s. It must be at most %2 km/s. The unit is km/s.</source>
        <translation>A velocidade é %1 km/s. Pode ser no máximo %2 km/s. A unidade é km/s.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time like 2024-05-10T04:50:02.5.</source>
        <translation>&quot;%1&quot; não é uma hora como 2024-05-10T04:50:02.5.</translation>
    </message>
    <message>
        <source>The row must have 6 numbers behind its time, or 9 with accelerations.</source>
        <translation>A linha tem de ter 6 números depois da hora, ou 9 com acelerações.</translation>
    </message>
    <message>
        <source>The table of %1 ended at %2.</source>
        <translation>A tabela de %1 acabou às %2.</translation>
    </message>
    <message>
        <source>The table of %1 begins at %2.</source>
        <translation>A tabela de %1 começa às %2.</translation>
    </message>
    <message>
        <source>The table of %1 has a gap from %2 to %3.</source>
        <translation>A tabela de %1 tem uma falha de %2 a %3.</translation>
    </message>
    <message>
        <source>The table of %1 has nothing above the horizon from %2 to %3.</source>
        <translation>A tabela de %1 não tem nada acima do horizonte de %2 a %3.</translation>
    </message>
    <message>
        <source>The file is a CCSDS message, but not an OEM. Boresight tracks tables and OEM.</source>
        <translation>O ficheiro é uma mensagem CCSDS, mas não um OEM. O Boresight segue tabelas e OEM.</translation>
    </message>
    <message>
        <source>antenna &quot;%1&quot; is in use</source>
        <translation>a antena &quot;%1&quot; está em uso</translation>
    </message>
    <message>
        <source>There is no antenna &quot;%1&quot;. The profile has %2.</source>
        <translation>Não há nenhuma antena &quot;%1&quot;. O perfil tem %2.</translation>
    </message>
    <message>
        <source>The list of antennas is not complete.</source>
        <translation>A lista de antenas não está completa.</translation>
    </message>
    <message>
        <source>Antenna</source>
        <translation>Antena</translation>
    </message>
    <message>
        <source>Refraction</source>
        <translation>Refração</translation>
    </message>
    <message>
        <source>There is no antenna &quot;%1&quot;. Name one of %2, or add [[antenna]] with this name.</source>
        <translation>Não há nenhuma antena &quot;%1&quot;. Indique uma de %2, ou acrescente [[antenna]] com este nome.</translation>
    </message>
    <message>
        <source>Offset across</source>
        <translation>Desvio lateral</translation>
    </message>
    <message>
        <source>Offset up</source>
        <translation>Desvio para cima</translation>
    </message>
    <message>
        <source>How far its beam points above the main beam. A negative value is below.</source>
        <translation>Quanto o seu feixe aponta acima do feixe principal. Um valor negativo é abaixo.</translation>
    </message>
    <message>
        <source>&quot;main&quot; is the name of the antenna that the table mount describes. Choose another name.</source>
        <translation>&quot;main&quot; é o nome da antena que a tabela mount descreve. Escolha outro nome.</translation>
    </message>
    <message>
        <source>The mount stands still. It moves again BY ITSELF if a position arrives before %2</source>
        <translation>A montagem está parada. Volta a mover-se POR SI se chegar uma posição antes de %2</translation>
    </message>
    <message>
        <source>Check the receiver and its program. STOP or Hold ends the tracking</source>
        <translation>Verifique o recetor e o programa que envia as posições. STOP ou Manter termina o seguimento</translation>
    </message>
    <message>
        <source>Press Track position on the page Passes when positions arrive again</source>
        <translation>Prima Seguir posição na página Passagens quando voltarem a chegar posições</translation>
    </message>
    <message>
        <source>no longer tracked: %1</source>
        <translation>deixou de ser seguido: %1</translation>
    </message>
    <message>
        <source>The transmit output %1 does not work: %2</source>
        <translation>A saída de emissão %1 não funciona: %2</translation>
    </message>
    <message>
        <source>Do not transmit: the output may still be on. Check it, or choose another one (transmit.output on the page Profile)</source>
        <translation>Não emita: a saída pode estar ainda ligada. Verifique-a, ou escolha outra (transmit.output na página Perfil)</translation>
    </message>
    <message>
        <source>%1 does not work: %2</source>
        <translation>%1 não funciona: %2</translation>
    </message>
    <message>
        <source>its time and the clock of this computer differ by %1 s</source>
        <translation>a sua hora e o relógio deste computador diferem %1 s</translation>
    </message>
    <message>
        <source>the position jumped by %1 km in %2 s</source>
        <translation>a posição saltou %1 km em %2 s</translation>
    </message>
    <message>
        <source>no position was received</source>
        <translation>não foi recebida nenhuma posição</translation>
    </message>
    <message>
        <source>no position was received for %1 s</source>
        <translation>não foi recebida nenhuma posição durante %1 s</translation>
    </message>
    <message>
        <source>the latitude is not within ±90°</source>
        <translation>a latitude não está dentro de ±90°</translation>
    </message>
    <message>
        <source>the longitude is not within -180° to 360°</source>
        <translation>a longitude não está entre -180° e 360°</translation>
    </message>
    <message>
        <source>the height is not within -1000 m to 2000000 m</source>
        <translation>a altitude não está entre -1000 m e 2000000 m</translation>
    </message>
    <message>
        <source>latitude and longitude are 0, as without a GPS fix</source>
        <translation>a latitude e a longitude são 0, como sem posição GPS</translation>
    </message>
    <message>
        <source>&quot;LATITUDE,LONGITUDE,METRES&quot; or a JSON object is expected</source>
        <translation>espera-se &quot;LATITUDE,LONGITUDE,METROS&quot; ou um objeto JSON</translation>
    </message>
    <message>
        <source>the time is not HH:MM:SS</source>
        <translation>a hora não é HH:MM:SS</translation>
    </message>
    <message>
        <source>the object has no latitude, longitude and altitude</source>
        <translation>o objeto não tem latitude, longitude e altitude</translation>
    </message>
    <message>
        <source>the message is longer than 4096 bytes</source>
        <translation>a mensagem tem mais de 4096 bytes</translation>
    </message>
    <message>
        <source>Boresight cannot listen on UDP %1:%2: %3</source>
        <translation>O Boresight não consegue escutar em UDP %1:%2: %3</translation>
    </message>
    <message>
        <source>a topic is expected, without + # and $</source>
        <translation>espera-se um tópico, sem + # e $</translation>
    </message>
    <message>
        <source>UDP port of the positions. radiosonde_auto_rx sends to 55673.</source>
        <translation>Porta UDP das posições. O radiosonde_auto_rx envia para 55673.</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>Tópico</translation>
    </message>
    <message>
        <source>MQTT: the topic of the positions.</source>
        <translation>MQTT: o tópico das posições.</translation>
    </message>
    <message>
        <source>Call sign</source>
        <translation>Indicativo</translation>
    </message>
    <message>
        <source>Longest silence</source>
        <translation>Silêncio mais longo</translation>
    </message>
    <message>
        <source>Without a position for this long the mount stands still.</source>
        <translation>Sem uma posição durante este tempo a montagem fica parada.</translation>
    </message>
    <message>
        <source>Fastest flight</source>
        <translation>Voo mais rápido</translation>
    </message>
    <message>
        <source>an address of this computer is expected while position.source is &quot;udp&quot;</source>
        <translation>espera-se um endereço deste computador enquanto position.source é &quot;udp&quot;</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Saída</translation>
    </message>
    <message>
        <source>The output is on while the beam is nearer to the target than this part of the beam width. At 0.5 the antenna sends half of its best power to the target.</source>
        <translation>A saída está ligada enquanto o feixe está mais perto do alvo do que esta parte da largura do feixe. Com 0.5 a antena envia para o alvo metade da sua melhor potência.</translation>
    </message>
    <message>
        <source>Also with a simulated mount</source>
        <translation>Também com montagem simulada</translation>
    </message>
    <message>
        <source>With &quot;off&quot; the output stays off while the mount is simulated, because the real antenna points elsewhere.</source>
        <translation>Com &quot;off&quot; a saída fica desligada enquanto a montagem é simulada, porque a antena real aponta para outro lado.</translation>
    </message>
    <message>
        <source>No position to track: %1</source>
        <translation>Não há posição para seguir: %1</translation>
    </message>
    <message>
        <source>the site of the mount was changed</source>
        <translation>o local da montagem foi alterado</translation>
    </message>
    <message>
        <source>the position</source>
        <translation>a posição</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posição</translation>
    </message>
    <message>
        <source>a position was refused: %1</source>
        <translation>uma posição foi recusada: %1</translation>
    </message>
    <message>
        <source>The mount is simulated (transmit.in_simulation).</source>
        <translation>A montagem é simulada (transmit.in_simulation).</translation>
    </message>
    <message>
        <source>STOP is latched.</source>
        <translation>STOP está retido.</translation>
    </message>
    <message>
        <source>The mount has a fault or does not reply.</source>
        <translation>A montagem tem uma falha ou não responde.</translation>
    </message>
    <message>
        <source>The mount has no target.</source>
        <translation>A montagem não tem alvo.</translation>
    </message>
    <message>
        <source>The target is below the horizon.</source>
        <translation>O alvo está abaixo do horizonte.</translation>
    </message>
    <message>
        <source>The mount reports no position.</source>
        <translation>A montagem não comunica a posição.</translation>
    </message>
    <message>
        <source>The beam has just come to the target.</source>
        <translation>O feixe acabou de chegar ao alvo.</translation>
    </message>
    <message>
        <source>The beam is %1 from the target. The limit is %2.</source>
        <translation>O feixe está a %1 do alvo. O limite é %2.</translation>
    </message>
    <message>
        <source>no answer for %1 s</source>
        <translation>sem resposta durante %1 s</translation>
    </message>
    <message>
        <source>on: the beam is %1 from the target</source>
        <translation>ligada: o feixe está a %1 do alvo</translation>
    </message>
    <message>
        <source>off: %1</source>
        <translation>desligada: %1</translation>
    </message>
    <message>
        <source>a path from / on is expected after the colon</source>
        <translation>espera-se um caminho a partir de / depois dos dois pontos</translation>
    </message>
    <message>
        <source>a topic is expected after the colon, without + # and $</source>
        <translation>espera-se um tópico depois dos dois pontos, sem + # e $</translation>
    </message>
    <message>
        <source>one line of at most 1000 bytes is expected</source>
        <translation>espera-se uma linha de no máximo 1000 bytes</translation>
    </message>
    <message>
        <source>%1 is used by %2</source>
        <translation>%1 está a ser usado por %2</translation>
    </message>
    <message>
        <source>%1 has no lines DTR and RTS</source>
        <translation>%1 não tem as linhas DTR e RTS</translation>
    </message>
    <message>
        <source>%1: the line did not change</source>
        <translation>%1: a linha não mudou</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 não é um ficheiro</translation>
    </message>
    <message>
        <source>The Moon of azel.dat is %1 away from the Moon that Boresight computes for the site</source>
        <translation>A Lua de azel.dat está a %1 da Lua que o Boresight calcula para o local</translation>
    </message>
    <message>
        <source>Boresight computes satellites, Sun and Moon with the new time</source>
        <translation>O Boresight calcula satélites, Sol e Lua com a nova hora</translation>
    </message>
    <message>
        <source>the file is from AirScout and has another form</source>
        <translation>o ficheiro é do AirScout e tem outra forma</translation>
    </message>
    <message>
        <source>%1: This file and %4 place satellite %2 %3 km apart. Boresight uses %4.</source>
        <translation>%1: Este ficheiro e %4 colocam o satélite %2 a %3 km um do outro. O Boresight usa %4.</translation>
    </message>
    <message>
        <source>A device at an aux port sends more data than configured, or at another speed</source>
        <translation>Um dispositivo numa porta aux envia mais dados do que o configurado, ou a outra velocidade</translation>
    </message>
    <message>
        <source>The supply does not absorb the braking energy</source>
        <translation>A fonte não absorve a energia de travagem</translation>
    </message>
    <message>
        <source>the %1 stopped replying</source>
        <translation>o %1 deixou de responder</translation>
    </message>
    <message>
        <source>the drives have not been checked yet</source>
        <translation>os acionamentos ainda não foram verificados</translation>
    </message>
    <message>
        <source>both drives stopped replying</source>
        <translation>ambos os acionamentos deixaram de responder</translation>
    </message>
    <message>
        <source>the rate of a crash-stop test must be %1 to %2°/s</source>
        <translation>a velocidade de uma prova de paragem tem de ser de %1 a %2°/s</translation>
    </message>
    <message>
        <source>crash stop from %1°/s: stopped after %2° and %3 ms</source>
        <translation>prova de paragem a partir de %1°/s: parou após %2° e %3 ms</translation>
    </message>
    <message>
        <source>the new plan does not contain this pass</source>
        <translation>o novo plano não contém esta passagem</translation>
    </message>
    <message>
        <source>%1. Changed by hand after that: %2</source>
        <translation>%1. Alterado à mão depois disso: %2</translation>
    </message>
    <message>
        <source>%1 earlier points are loaded. They count when every drive has reported its identity</source>
        <translation>%1 pontos anteriores foram lidos. Contam quando todos os acionamentos tiverem comunicado a sua identidade</translation>
    </message>
    <message>
        <source>Whether the satellite is a favourite, with a star and a place in the timeline.</source>
        <translation>Se o satélite é um favorito, com uma estrela e um lugar na linha do tempo.</translation>
    </message>
    <message>
        <source>Whether the mount stands still while WSJT-X transmits. It catches up in the next receive period.</source>
        <translation>Se a montagem fica parada enquanto o WSJT-X emite. Recupera no período de receção seguinte.</translation>
    </message>
    <message>
        <source>Only the part of its passes above this elevation counts.</source>
        <translation>Só conta a parte das passagens acima desta elevação.</translation>
    </message>
    <message>
        <source>The program before AOS runs this long before AOS. It never runs before LOS of the previous pass.</source>
        <translation>O programa antes de AOS corre este tempo antes de AOS. Nunca corre antes de LOS da passagem anterior.</translation>
    </message>
    <message>
        <source>Which of two overlapping passes is tracked: the pass of the more important satellite, the longer pass, or the pass that begins first.</source>
        <translation>Qual de duas passagens sobrepostas é seguida: a do satélite mais importante, a mais longa, ou a que começa primeiro.</translation>
    </message>
    <message>
        <source>With &quot;off&quot; nothing moves after a start until a person arms the schedule. With &quot;on&quot; it arms itself once after each start, and the mount moves with nobody present.</source>
        <translation>Com &quot;off&quot; nada se move depois de um arranque até que alguém arme a agenda. Com &quot;on&quot; ela arma-se uma vez depois de cada arranque, e a montagem move-se sem ninguém presente.</translation>
    </message>
    <message>
        <source>Uncertainty (1 sigma) of the north that the swing found. 0: unknown.</source>
        <translation>Incerteza (1 sigma) do norte que o giro encontrou. 0: desconhecida.</translation>
    </message>
    <message>
        <source>Elevation of the boom during the compass swing. The measured error is most exact there.</source>
        <translation>Elevação da lança durante o giro da bússola. Aí o erro medido é mais exato.</translation>
    </message>
    <message>
        <source>The largest torque that the drive uses, as its controller measures it.</source>
        <translation>O maior binário que o acionamento usa, tal como o controlador o mede.</translation>
    </message>
    <message>
        <source>What Boresight does after this computer stalled for up to 2 s and the watchdogs stopped the drives: resume the motion, or wait for a re-arm.</source>
        <translation>O que o Boresight faz depois de este computador ter parado até 2 s e os watchdogs terem parado os acionamentos: retomar o movimento, ou esperar por um rearme.</translation>
    </message>
    <message>
        <source>Form of the \dump_state reply. Every version of Hamlib reads &quot;old_and_new&quot;. &quot;as_hamlib&quot; is exactly the reply of Hamlib 4.5.1 and later.</source>
        <translation>Forma da resposta \dump_state. Todas as versões de Hamlib leem &quot;old_and_new&quot;. &quot;as_hamlib&quot; é exatamente a resposta de Hamlib 4.5.1 e posteriores.</translation>
    </message>
    <message>
        <source>built in, needs no hardware</source>
        <translation>incluído, não precisa de equipamento</translation>
    </message>
    <message>
        <source>%1 moves the wrong way: it moved %5 in %4 instead of %2 (at %3)</source>
        <translation>%1 move-se no sentido errado: moveu-se %5 em %4 em vez de %2 (a %3)</translation>
    </message>
    <message>
        <source>Set at least ten times the bandwidth of the position control. With less, the measured speed lags too much for the damping.</source>
        <translation>Defina pelo menos dez vezes a largura de banda do controlo de posição. Com menos, a velocidade medida atrasa-se demasiado para o amortecimento.</translation>
    </message>
    <message>
        <source>%1 is the site of the mount, so it has no direction.</source>
        <translation>%1 é o local da montagem, por isso não tem direção.</translation>
    </message>
    <message>
        <source>The file was not read within %1 s. Nothing moves. Track it again.</source>
        <translation>O ficheiro não foi lido em %1 s. Nada se move. Siga-o outra vez.</translation>
    </message>
    <message>
        <source>The target is outside the limits of the mount.</source>
        <translation>O alvo está fora dos limites da montagem.</translation>
    </message>
    <message>
        <source>The balloon or rocket cannot be tracked: %1</source>
        <translation>Não é possível seguir o balão ou foguetão: %1</translation>
    </message>
    <message>
        <source>The balloon or rocket is no longer tracked: %1</source>
        <translation>O balão ou foguetão deixou de ser seguido: %1</translation>
    </message>
    <message>
        <source>the report is from another call sign than %1</source>
        <translation>a comunicação é de um indicativo diferente de %1</translation>
    </message>
    <message>
        <source>the object is not a PAYLOAD_SUMMARY</source>
        <translation>o objeto não é um PAYLOAD_SUMMARY</translation>
    </message>
    <message>
        <source>is the same as a topic of the sensor</source>
        <translation>é igual a um tópico do sensor</translation>
    </message>
    <message>
        <source>Nothing corrects the declination. The sensor adds %1 to the heading.</source>
        <translation>Nada corrige a declinação. O sensor soma %1 ao rumo.</translation>
    </message>
    <message>
        <source>Real-time scheduling: off. Boresight gave it back after 0.1 s of work without a pause.</source>
        <translation>Escalonamento em tempo real: desligado. O Boresight devolveu-o após 0,1 s de trabalho sem pausa.</translation>
    </message>
    <message>
        <source>%1 does not move: it was %2 away from its set-point for %5, with %3 Nm of the %4 Nm allowed</source>
        <translation>%1 não se move: esteve a %2 do seu ponto de referência durante %5, com %3 Nm dos %4 Nm permitidos</translation>
    </message>
    <message>
        <source>The frame %1 has the fixed date REF_FRAME_EPOCH. Boresight reads this frame only with the date of each row. Use GCRF.</source>
        <translation>O referencial %1 tem a data fixa REF_FRAME_EPOCH. O Boresight só lê este referencial com a data de cada linha. Use GCRF.</translation>
    </message>
    <message>
        <source>This segment begins before the end of the segment above it. Sort the segments, or set USEABLE_START_TIME.</source>
        <translation>Este segmento começa antes do fim do segmento acima. Ordene os segmentos ou defina USEABLE_START_TIME.</translation>
    </message>
    <message>
        <source>The position is %1 km from the centre of the Earth. The range is %2 to %3 km. Check the unit: positions are in km.</source>
        <translation>A posição está a %1 km do centro da Terra. O intervalo é de %2 a %3 km. Verifique a unidade: as posições são em km.</translation>
    </message>
    <message>
        <source>%1 (axes %2)</source>
        <translation>%1 (eixos %2)</translation>
    </message>
    <message>
        <source>The %1 timed out because this computer stalled for %2</source>
        <translation>O %1 excedeu o tempo porque este computador parou durante %2</translation>
    </message>
    <message>
        <source>Switch off the sleep of this computer, or find the program that blocks it.</source>
        <translation>Desative a suspensão deste computador, ou procure o programa que o bloqueia.</translation>
    </message>
    <message>
        <source>The line to the rotator is down: %1</source>
        <translation>A ligação ao rotor está em baixo: %1</translation>
    </message>
    <message>
        <source>Boresight can command nothing. It tries to open the line again each second</source>
        <translation>O Boresight não pode comandar nada. Tenta abrir a ligação de novo a cada segundo</translation>
    </message>
    <message>
        <source>Check the cable and the box. If the port is wrong, choose another one on the page Profile (bus.name)</source>
        <translation>Verifique o cabo e a caixa. Se a porta estiver errada, escolha outra na página Perfil (bus.name)</translation>
    </message>
    <message>
        <source>The rotator does not answer</source>
        <translation>O rotor não responde</translation>
    </message>
    <message>
        <source>The rotator fell silent in motion</source>
        <translation>O rotor deixou de responder em movimento</translation>
    </message>
    <message>
        <source>Look at the mount. Check the power of the box and the cable.</source>
        <translation>Observe a montagem. Verifique a alimentação da caixa e o cabo.</translation>
    </message>
    <message>
        <source>The %1 stands at %2 although it was sent to %3 twice</source>
        <translation>O %1 está parado em %2 embora tenha sido enviado duas vezes para %3</translation>
    </message>
    <message>
        <source>Boresight sent a stop and ended the motion</source>
        <translation>O Boresight enviou uma paragem e terminou o movimento</translation>
    </message>
    <message>
        <source>Look for a blocked axis, a motor without power, or a box that was switched to manual.</source>
        <translation>Procure um eixo bloqueado, um motor sem alimentação ou uma caixa em modo manual.</translation>
    </message>
    <message>
        <source>The position of the %1 jumped from %2 to %3</source>
        <translation>A posição do %1 saltou de %2 para %3</translation>
    </message>
    <message>
        <source>Compare the position with the mount and its cable. Calibrate the box if it is wrong.</source>
        <translation>Compare a posição com a montagem e o seu cabo. Calibre a caixa se estiver errada.</translation>
    </message>
    <message>
        <source>The %1 still turns after several stops</source>
        <translation>O %1 continua a rodar depois de várias paragens</translation>
    </message>
    <message>
        <source>Boresight repeats the stop each second</source>
        <translation>O Boresight repete a paragem a cada segundo</translation>
    </message>
    <message>
        <source>Switch the rotator off at its box.</source>
        <translation>Desligue o rotor na sua caixa.</translation>
    </message>
    <message>
        <source>%1 answers as a %2</source>
        <translation>%1 responde como um %2</translation>
    </message>
    <message>
        <source>the %1 fell silent</source>
        <translation>o %1 ficou mudo</translation>
    </message>
    <message>
        <source>The rotator refuses the question for both axes. If it has no elevation, set elevation.driver to &quot;none&quot;</source>
        <translation>O rotor recusa a pergunta sobre os dois eixos. Se não tiver elevação, ponha elevation.driver em &quot;none&quot;</translation>
    </message>
    <message>
        <source>%1 is gone. Plug its cable in again</source>
        <translation>%1 desapareceu. Volte a ligar o cabo</translation>
    </message>
    <message>
        <source>%1 is gone. Plug its cable in again, in any socket. Boresight finds it as %2</source>
        <translation>%1 desapareceu. Volte a ligar o cabo, em qualquer tomada. O Boresight encontra-o como %2</translation>
    </message>
    <message>
        <source>the other end closed the connection</source>
        <translation>o outro lado fechou a ligação</translation>
    </message>
    <message>
        <source>%1: %2. Check its power, its address and its network</source>
        <translation>%1: %2. Verifique a alimentação, o endereço e a rede</translation>
    </message>
    <message>
        <source>The driver &quot;%1&quot; needs fdcanusb:PATH or socketcan:INTERFACE.</source>
        <translation>O controlador &quot;%1&quot; precisa de fdcanusb:PATH ou socketcan:INTERFACE.</translation>
    </message>
    <message>
        <source>The driver &quot;%1&quot; needs serial:PATH or tcp:HOST:PORT.</source>
        <translation>O controlador &quot;%1&quot; precisa de serial:PATH ou tcp:HOST:PORT.</translation>
    </message>
    <message>
        <source>Speed of the serial port</source>
        <translation>Velocidade da porta série</translation>
    </message>
    <message>
        <source>Boresight closed the line, and sends nothing more</source>
        <translation>O Boresight fechou a linha e não envia mais nada</translation>
    </message>
    <message>
        <source>Check the port and the speed (bus.name, bus.baud). Then press Reconnect</source>
        <translation>Verifique a porta e a velocidade (bus.name, bus.baud). Depois prima Reconectar</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and azimuth.driver &quot;%2&quot; need two buses, and bus.name names only one. Choose one driver for both axes, or &quot;none&quot; for one of them.</source>
        <translation>&quot;%1&quot; e azimuth.driver &quot;%2&quot; precisam de dois barramentos, e bus.name indica apenas um. Escolha o mesmo driver para os dois eixos, ou &quot;none&quot; para um deles.</translation>
    </message>
    <message>
        <source>End the program that commands the drive. If there is none, press STOP</source>
        <translation>Termine o programa que comanda o acionamento. Se não houver nenhum, prima STOP</translation>
    </message>
    <message>
        <source>Tracking uses this clock</source>
        <translation>O seguimento usa este relógio</translation>
    </message>
    <message>
        <source>The calibration is in force. Its history is lost when Boresight ends</source>
        <translation>A calibração está em vigor. O seu histórico perde-se quando o Boresight terminar</translation>
    </message>
    <message>
        <source>Check the axis or device that this board moves.</source>
        <translation>Verifique o eixo ou o dispositivo que esta placa move.</translation>
    </message>
    <message>
        <source>Boresight moves nothing. The board&apos;s reports may mean something else</source>
        <translation>O Boresight não move nada. Os dados da placa podem ter outro significado</translation>
    </message>
    <message>
        <source>More than %1 elements stand inside one another.</source>
        <translation>Mais de %1 elementos estão uns dentro dos outros.</translation>
    </message>
    <message>
        <source>The line returns what Boresight sends. Connect the rotator to it. If a modem is connected, switch the modem off</source>
        <translation>A ligação devolve o que o Boresight envia. Ligue o rotor a ela. Se houver um modem ligado, desligue o modem</translation>
    </message>
    <message>
        <source>The profile has no site. Enter the site on the page Profile</source>
        <translation>O perfil não tem local. Introduza o local na página Perfil</translation>
    </message>
    <message>
        <source>Your level is right to %1.</source>
        <translation>O seu nivelamento está certo até %1.</translation>
    </message>
    <message>
        <source>Your level is off by %1 ± %2.</source>
        <translation>O seu nivelamento está errado em %1 ± %2.</translation>
    </message>
    <message>
        <source>UDP: the address of this computer to listen on. 127.0.0.1 receives from this computer only, 0.0.0.0 receives from all computers, broadcasts included.</source>
        <translation>UDP: o endereço deste computador em que se escuta. 127.0.0.1 recebe só deste computador, 0.0.0.0 recebe de todos os computadores, incluindo difusões.</translation>
    </message>
    <message>
        <source>Half-power beam width of the antenna.</source>
        <translation>Largura de feixe a meia potência da antena.</translation>
    </message>
    <message>
        <source>sent more than %1 bytes during the pause it asked for</source>
        <translation>enviou mais de %1 bytes durante a pausa que pediu</translation>
    </message>
    <message>
        <source>closed the connection during the pause it asked for</source>
        <translation>fechou a ligação durante a pausa que pediu</translation>
    </message>
    <message>
        <source>the new position is %1 from the last position</source>
        <translation>a nova posição está a %1 da última posição</translation>
    </message>
    <message>
        <source>a false reply reports that %1 jumped by %2 in %3 to %4</source>
        <translation>uma resposta falsa indica que o %1 saltou %2 em %3 para %4</translation>
    </message>
    <message>
        <source>The time is not later than the time in the row above. Sort the rows by time.</source>
        <translation>A hora não é posterior à hora da linha acima. Ordene as linhas por hora.</translation>
    </message>
    <message>
        <source>The direction is %1 from the direction in the row above. It must be below 90°. Add rows between them.</source>
        <translation>A direção está a %1 da direção da linha acima. Tem de estar a menos de 90°. Acrescente linhas entre elas.</translation>
    </message>
    <message>
        <source>The place is %1° around the Earth from the place in the row above. It must be below %2°. Add rows between them.</source>
        <translation>O lugar está a %1° à volta da Terra do lugar da linha acima. Tem de ser menos de %2°. Acrescente linhas entre eles.</translation>
    </message>
    <message>
        <source>The element &lt;%1&gt; has no place here in an OEM.</source>
        <translation>O elemento &lt;%1&gt; não tem lugar aqui num OEM.</translation>
    </message>
    <message>
        <source>The file has an element &lt;%1&gt;. Boresight tracks only &lt;oem&gt;.</source>
        <translation>O ficheiro tem um elemento &lt;%1&gt;. O Boresight só segue &lt;oem&gt;.</translation>
    </message>
    <message>
        <source>The file has a second &lt;oem&gt;. Make two files.</source>
        <translation>O ficheiro tem um segundo &lt;oem&gt;. Faça dois ficheiros.</translation>
    </message>
    <message>
        <source>%1 is &quot;%2&quot;. It must be one value.</source>
        <translation>%1 é &quot;%2&quot;. Tem de ser um só valor.</translation>
    </message>
    <message>
        <source>The row has no &lt;%1&gt;.</source>
        <translation>A linha não tem &lt;%1&gt;.</translation>
    </message>
    <message>
        <source>The axis follows swings up to %1 Hz.</source>
        <translation>O eixo acompanha oscilações até %1 Hz.</translation>
    </message>
    <message>
        <source>Boresight commands only small steps</source>
        <translation>O Boresight comanda só pequenos passos</translation>
    </message>
    <message>
        <source>This rotator counts its angles itself: %1.sign and %1.offset_deg have no effect on it. Set them to 1 and 0, and calibrate the count at its box.</source>
        <translation>Este rotor conta ele próprio os seus ângulos: %1.sign e %1.offset_deg não têm efeito nele. Ponha-os a 1 e 0 e calibre a contagem na sua caixa.</translation>
    </message>
    <message>
        <source>The device on %1 is not %2. It sent &quot;%3&quot;</source>
        <translation>O dispositivo em %1 não é %2. Enviou &quot;%3&quot;</translation>
    </message>
    <message>
        <source>a GS-232 rotator</source>
        <translation>um rotor GS-232</translation>
    </message>
    <message>
        <source>the value is outside the limits of rotctld</source>
        <translation>o valor está fora dos limites do rotctld</translation>
    </message>
    <message>
        <source>rotctld is configured wrongly</source>
        <translation>o rotctld está mal configurado</translation>
    </message>
    <message>
        <source>this rotator does not have the function</source>
        <translation>este rotor não tem esta função</translation>
    </message>
    <message>
        <source>the rotator did not answer rotctld in time</source>
        <translation>o rotor não respondeu ao rotctld a tempo</translation>
    </message>
    <message>
        <source>rotctld cannot use the port of the rotator</source>
        <translation>o rotctld não consegue usar a porta do rotor</translation>
    </message>
    <message>
        <source>rotctld did not understand the answer of the rotator</source>
        <translation>o rotctld não compreendeu a resposta do rotor</translation>
    </message>
    <message>
        <source>the rotator rejected the command</source>
        <translation>o rotor rejeitou o comando</translation>
    </message>
    <message>
        <source>the rotator is switched off</source>
        <translation>o rotor está desligado</translation>
    </message>
    <message>
        <source>the position is outside the limits of rotctld</source>
        <translation>a posição está fora dos limites do rotctld</translation>
    </message>
    <message>
        <source>rotctld denied the access</source>
        <translation>o rotctld negou o acesso</translation>
    </message>
    <message>
        <source>rotctld reported an error</source>
        <translation>o rotctld comunicou um erro</translation>
    </message>
    <message>
        <source>Boresight keeps asking for its position. It sends no motion commands</source>
        <translation>O Boresight continua a pedir a sua posição. Não envia comandos de movimento</translation>
    </message>
    <message>
        <source>The rotator refused its target: %1</source>
        <translation>O rotor recusou o seu alvo: %1</translation>
    </message>
    <message>
        <source>Compare the travel of the profile with the limits of the rotator, and check its power.</source>
        <translation>Compare o curso do perfil com os limites do rotor e verifique a sua alimentação.</translation>
    </message>
    <message>
        <source>%1: %2. Check that rotctld runs there. Check its address, its port and the network</source>
        <translation>%1: %2. Verifique se o rotctld corre lá. Verifique o seu endereço, a sua porta e a rede</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sem resposta</translation>
    </message>
    <message>
        <source>This rotator has no azimuth. Set azimuth.driver to &quot;none&quot; in the profile.</source>
        <translation>Este rotor não tem azimute. Ponha azimuth.driver em &quot;none&quot; no perfil.</translation>
    </message>
    <message>
        <source>This rotator has no elevation. Set elevation.driver to &quot;none&quot; in the profile.</source>
        <translation>Este rotor não tem elevação. Ponha elevation.driver em &quot;none&quot; no perfil.</translation>
    </message>
    <message>
        <source>The travel %1…%2 does not fit this rotator. Its rotctld permits %3…%4. Change %5.travel_min_deg and %5.travel_max_deg in the profile.</source>
        <translation>O curso %1…%2 não serve a este rotor. O seu rotctld permite %3…%4. Altere %5.travel_min_deg e %5.travel_max_deg no perfil.</translation>
    </message>
    <message>
        <source>a rotctld</source>
        <translation>um rotctld</translation>
    </message>
    <message>
        <source>The answer of rotctld is: %1. Check the rotator, its power, its cable and the options of rotctld</source>
        <translation>A resposta do rotctld é: %1. Verifique o rotor, a sua alimentação, o seu cabo e as opções do rotctld</translation>
    </message>
    <message>
        <source>%1 was tracked for %2 s. Within 1 dB: %3 s. Within 3 dB: %4 s.</source>
        <translation>%1 foi seguido durante %2 s. A menos de 1 dB: %3 s. A menos de 3 dB: %4 s.</translation>
    </message>
    <message>
        <source>Error: %1° rms. Largest error: %2°.</source>
        <translation>Erro: %1° rms. Erro máximo: %2°.</translation>
    </message>
    <message>
        <source>The beam was never on target.</source>
        <translation>O feixe nunca esteve no alvo.</translation>
    </message>
    <message>
        <source>Check that rotctld still runs there (%1). If it hangs, end it and start it again</source>
        <translation>Verifique se o rotctld ainda corre lá (%1). Se estiver bloqueado, termine-o e arranque-o de novo</translation>
    </message>
    <message>
        <source>The running pass could not be stored: %1</source>
        <translation>Não foi possível guardar a passagem em curso: %1</translation>
    </message>
    <message>
        <source>The file of the last pass cannot be read: %1. The next pass replaces it.</source>
        <translation>O ficheiro da última passagem não pode ser lido: %1. A próxima passagem substitui-o.</translation>
    </message>
    <message>
        <source>stands still while WSJT-X transmits</source>
        <translation>parada enquanto o WSJT-X transmite</translation>
    </message>
    <message>
        <source>Further clients cannot connect: %1</source>
        <translation>Outros clientes não se podem ligar: %1</translation>
    </message>
    <message>
        <source>Boresight serves its other listeners</source>
        <translation>O Boresight serve as suas outras escutas</translation>
    </message>
    <message>
        <source>End the other program, or choose another place (listeners.list on the page Profile). Then press Reconnect</source>
        <translation>Termine o outro programa, ou escolha outro lugar (listeners.list na página Perfil). Depois prima Religar</translation>
    </message>
    <message>
        <source>Add the addresses that may connect to the listener (listeners.list on the page Profile), or let it listen on 127.0.0.1</source>
        <translation>Acrescente à escuta os endereços que se podem ligar (listeners.list na página Perfil), ou faça-a escutar em 127.0.0.1</translation>
    </message>
    <message>
        <source>The listener of this client has the right &quot;read&quot; (listeners.list in the profile).</source>
        <translation>A escuta deste cliente tem o direito &quot;read&quot; (listeners.list no perfil).</translation>
    </message>
    <message>
        <source>azimuth %1 is outside 0°…450°</source>
        <translation>o azimute %1 está fora de 0°…450°</translation>
    </message>
    <message>
        <source>elevation %1 is outside 0°…180°</source>
        <translation>a elevação %1 está fora de 0°…180°</translation>
    </message>
    <message>
        <source>lists of positions are not supported</source>
        <translation>as listas de posições não são suportadas</translation>
    </message>
    <message>
        <source>GS-232 has no number for the azimuth %1</source>
        <translation>O GS-232 não tem número para o azimute %1</translation>
    </message>
    <message>
        <source>this command of GS-232 is not supported</source>
        <translation>este comando do GS-232 não é suportado</translation>
    </message>
    <message>
        <source>GS-232 has no number for the elevation %1</source>
        <translation>O GS-232 não tem número para a elevação %1</translation>
    </message>
    <message>
        <source>protocol, rights and place are expected, like &quot;gs232b drive tcp:127.0.0.1:4534&quot;</source>
        <translation>espera-se protocolo, direitos e lugar, como &quot;gs232b drive tcp:127.0.0.1:4534&quot;</translation>
    </message>
    <message>
        <source>the protocol &quot;%1&quot; is unknown. Known are: %2</source>
        <translation>o protocolo &quot;%1&quot; é desconhecido. Conhecem-se: %2</translation>
    </message>
    <message>
        <source>the rights &quot;%1&quot; are neither &quot;drive&quot; nor &quot;read&quot;</source>
        <translation>os direitos &quot;%1&quot; não são &quot;drive&quot; nem &quot;read&quot;</translation>
    </message>
    <message>
        <source>Further listeners</source>
        <translation>Outras escutas</translation>
    </message>
    <message>
        <source>refused: its address is not permitted (%1)</source>
        <translation>recusado: o seu endereço não é permitido (%1)</translation>
    </message>
    <message>
        <source>its address is no longer permitted (%1)</source>
        <translation>o seu endereço deixou de ser permitido (%1)</translation>
    </message>
    <message>
        <source>cannot serve the pseudo-terminal %1: %2</source>
        <translation>não é possível servir o pseudoterminal %1: %2</translation>
    </message>
    <message>
        <source>its folder is missing or cannot be written</source>
        <translation>a sua pasta não existe ou não se pode escrever nela</translation>
    </message>
    <message>
        <source>%1 listens on %2</source>
        <translation>%1 escuta em %2</translation>
    </message>
    <message>
        <source>Another command came before the rotctld had answered. Track it again.</source>
        <translation>Outro comando chegou antes de o rotctld responder. Siga-o outra vez.</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 não responde</translation>
    </message>
    <message>
        <source>the mount does not follow %1</source>
        <translation>a montagem não segue %1</translation>
    </message>
    <message>
        <source>No position of %1 was received</source>
        <translation>Não foi recebida nenhuma posição de %1</translation>
    </message>
    <message>
        <source>follow %1</source>
        <translation>seguir %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no rotctld. Write rotctld:HOST:PORT, for example rotctld:10.0.0.7:4533.</source>
        <translation>&quot;%1&quot; não designa um rotctld. Escreva rotctld:HOST:PORT, por exemplo rotctld:10.0.0.7:4533.</translation>
    </message>
    <message>
        <source>%1 is the server of Boresight itself. Name the rotctld of another rotator.</source>
        <translation>%1 é o servidor do próprio Boresight. Indique o rotctld de outro rotor.</translation>
    </message>
    <message>
        <source>%1 turns this mount. Name the rotctld of another rotator.</source>
        <translation>%1 move esta montagem. Indique o rotctld de outro rotor.</translation>
    </message>
    <message>
        <source>registers and inputs are not supported</source>
        <translation>os registos e as entradas não são suportados</translation>
    </message>
    <message>
        <source>a line has more than %1 words</source>
        <translation>uma linha tem mais de %1 palavras</translation>
    </message>
    <message>
        <source>a line asks for two motions</source>
        <translation>uma linha pede dois movimentos</translation>
    </message>
    <message>
        <source>GS-232 rotator (Yaesu and others), by serial port or network</source>
        <translation>Rotor GS-232 (Yaesu e outros), por porta série ou rede</translation>
    </message>
    <message>
        <source>A serial port such as /dev/ttyUSB0, or HOST:PORT of a serial server</source>
        <translation>Uma porta série como /dev/ttyUSB0, ou HOST:PORTA de um servidor de portas série</translation>
    </message>
    <message>
        <source>/dev/ttyUSB0 or 192.168.1.20:4001</source>
        <translation>/dev/ttyUSB0 ou 192.168.1.20:4001</translation>
    </message>
    <message>
        <source>Connect asks for the position. Nothing moves.</source>
        <translation>Conectar pergunta a posição. Nada se move.</translation>
    </message>
    <message>
        <source>A device of another kind is left alone.</source>
        <translation>Um aparelho de outro tipo é deixado em paz.</translation>
    </message>
    <message>
        <source>Check the power of the box, and the cable.</source>
        <translation>Verifique a alimentação da caixa e o cabo.</translation>
    </message>
    <message>
        <source>Compare the speed with the switches of the box.</source>
        <translation>Compare a velocidade com os interruptores da caixa.</translation>
    </message>
    <message>
        <source>End other programs that use the port.</source>
        <translation>Termine outros programas que usam a porta.</translation>
    </message>
    <message>
        <source>moteus drives on a CAN bus, or the simulated mount</source>
        <translation>Acionamentos moteus num barramento CAN, ou a montagem simulada</translation>
    </message>
    <message>
        <source>The site of the mount is unknown. Enter it on the page Profile.</source>
        <translation>O local da montagem é desconhecido. Introduza-o na página Perfil.</translation>
    </message>
    <message>
        <source>azimuth %1 is outside -3600°…3600°</source>
        <translation>o azimute %1 está fora de -3600°…3600°</translation>
    </message>
    <message>
        <source>elevation %1 is outside -90°…180°</source>
        <translation>a elevação %1 está fora de -90°…180°</translation>
    </message>
    <message>
        <source>At %1 Boresight itself listens for programs (rotctld.listen). Start the rotctld of the rotator on another port, for example rotctld -t 4534.</source>
        <translation>Em %1 é o próprio Boresight que escuta programas (rotctld.listen). Inicie o rotctld do rotor noutra porta, por exemplo rotctld -t 4534.</translation>
    </message>
    <message>
        <source>cannot serve the socket %1: %2</source>
        <translation>não é possível servir o socket %1: %2</translation>
    </message>
    <message>
        <source>another program listens there</source>
        <translation>outro programa escuta aí</translation>
    </message>
    <message>
        <source>a path has at most %1 bytes</source>
        <translation>um caminho tem no máximo %1 bytes</translation>
    </message>
    <message>
        <source>Any rotator that Hamlib drives, by a rotctld</source>
        <translation>Qualquer rotor que o Hamlib comanda, através de um rotctld</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Endereço</translation>
    </message>
    <message>
        <source>HOST:PORT of rotctld. 127.0.0.1 is this computer. Without a port it is %1</source>
        <translation>HOST:PORTA do rotctld. 127.0.0.1 é este computador. Sem porta é a %1</translation>
    </message>
    <message>
        <source>rotctld runs on the computer that has the cable of the rotator. Example: rotctld -m 901 -r /dev/ttyUSB0</source>
        <translation>O rotctld corre no computador que tem o cabo do rotor. Exemplo: rotctld -m 901 -r /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>Connect asks rotctld for the limits and for the position. Nothing moves.</source>
        <translation>Conectar pergunta ao rotctld os limites e a posição. Nada se move.</translation>
    </message>
    <message>
        <source>A server of another kind is asked one question and left alone.</source>
        <translation>A um servidor de outro tipo é feita uma só pergunta.</translation>
    </message>
    <message>
        <source>Check that rotctld runs on that computer, and that its rotator has power.</source>
        <translation>Verifique que o rotctld corre nesse computador e que o rotor tem alimentação.</translation>
    </message>
    <message>
        <source>Compare the port with the option -t of rotctld. Without -t it is %1.</source>
        <translation>Compare a porta com a opção -t do rotctld. Sem -t é a %1.</translation>
    </message>
    <message>
        <source>From another computer: start rotctld with -T 0.0.0.0, and open its port in the firewall.</source>
        <translation>A partir de outro computador: inicie o rotctld com -T 0.0.0.0 e abra a porta na firewall.</translation>
    </message>
    <message>
        <source>turns at %1°/s, the fastest jog rate</source>
        <translation>roda a %1°/s, a velocidade manual mais rápida</translation>
    </message>
    <message>
        <source>Park now</source>
        <translation>Estacionar agora</translation>
    </message>
    <message>
        <source>Move anyway</source>
        <translation>Mover mesmo assim</translation>
    </message>
    <message>
        <source>The mount parks and stays parked. Boresight refuses every other motion</source>
        <translation>A montagem estaciona e fica estacionada. O Boresight recusa qualquer outro movimento</translation>
    </message>
    <message>
        <source>Press Park now. If the mount must move elsewhere first, press Move anyway</source>
        <translation>Prima Estacionar agora. Se a montagem tiver de ir antes a outro lado, prima Mover mesmo assim</translation>
    </message>
    <message>
        <source>Watch the antenna. Press Park now when the work is done</source>
        <translation>Observe a antena. Prima Estacionar agora quando o trabalho acabar</translation>
    </message>
    <message>
        <source>Check the anemometer and its program, and wind.source on the page Profile. Park the mount if a strong wind is possible</source>
        <translation>Verifique o anemómetro e o seu programa, e wind.source na página Perfil. Estacione a montagem se for possível vento forte</translation>
    </message>
    <message>
        <source>unknown bus &apos;%1&apos;. Write simulated, socketcan:INTERFACE, fdcanusb:PATH, serial:PATH, tcp:HOST:PORT, rotctld:HOST:PORT or hamlib:MODEL:PORT</source>
        <translation>barramento desconhecido &apos;%1&apos;. Escreva simulated, socketcan:INTERFACE, fdcanusb:CAMINHO, serial:CAMINHO, tcp:HOST:PORTA, rotctld:HOST:PORTA ou hamlib:MODELO:PORTA</translation>
    </message>
    <message>
        <source>lets the mount move in the wind until %1</source>
        <translation>deixa a montagem mover-se com vento até às %1</translation>
    </message>
    <message>
        <source>The wind reached %1 m/s. The limit is %2 m/s</source>
        <translation>O vento atingiu %1 m/s. O limite é %2 m/s</translation>
    </message>
    <message>
        <source>%1 Only Park moves the mount until the wind stays below %2 m/s for %3 min.</source>
        <translation>%1 Só Estacionar move a montagem até o vento ficar abaixo de %2 m/s durante %3 min.</translation>
    </message>
    <message>
        <source>The wind does not forbid any motion.</source>
        <translation>O vento não proíbe nenhum movimento.</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vento</translation>
    </message>
    <message>
        <source>loses the pass of %1: %2</source>
        <translation>perde a passagem de %1: %2</translation>
    </message>
    <message>
        <source>%1: The server answers %2.</source>
        <translation>%1: O servidor responde %2.</translation>
    </message>
    <message>
        <source>The driver &quot;%1&quot; needs rotctld:HOST:PORT or hamlib:MODEL:PORT.</source>
        <translation>O controlador &quot;%1&quot; precisa de rotctld:HOST:PORTA ou hamlib:MODELO:PORTA.</translation>
    </message>
    <message>
        <source>How Boresight reaches the drives: &quot;fdcanusb:PATH&quot; or &quot;socketcan:INTERFACE&quot; for moteus, &quot;serial:PATH&quot; or &quot;tcp:HOST:PORT&quot; for a GS-232 rotator, &quot;rotctld:HOST:PORT&quot; or &quot;hamlib:MODEL:PORT&quot; for a rotator of Hamlib, or &quot;simulated&quot;.</source>
        <translation>Como o Boresight chega aos acionamentos: &quot;fdcanusb:CAMINHO&quot; ou &quot;socketcan:INTERFACE&quot; para moteus, &quot;serial:CAMINHO&quot; ou &quot;tcp:HOST:PORTA&quot; para um rotor GS-232, &quot;rotctld:HOST:PORTA&quot; ou &quot;hamlib:MODELO:PORTA&quot; para um rotor do Hamlib, ou &quot;simulated&quot;.</translation>
    </message>
    <message>
        <source>Speed of the serial port of a GS-232 rotator or of a model of Hamlib, as its switches are set. A CAN bus does not use it.</source>
        <translation>Velocidade da porta série de um rotor GS-232 ou de um modelo do Hamlib, tal como os seus interruptores estão postos. Um barramento CAN não a usa.</translation>
    </message>
    <message>
        <source>Park when idle</source>
        <translation>Estacionar quando parada</translation>
    </message>
    <message>
        <source>The mount parks after this time without a motion and without a command of the operator or of a client. A client that only reads the position does not count. 0: never.</source>
        <translation>A montagem estaciona após este tempo sem movimento e sem comando do operador ou de um cliente. Um cliente que só lê a posição não conta. 0: nunca.</translation>
    </message>
    <message>
        <source>a word of at most %1 characters is expected</source>
        <translation>espera-se uma palavra com %1 caracteres no máximo</translation>
    </message>
    <message>
        <source>Where the readings of an anemometer arrive: udp:PORT on this computer, udp:0.0.0.0:PORT from all computers, mqtt:TOPIC of the MQTT broker, or the page of a web server, such as http://anemometer/wind. Empty: none, and the wind parks nothing.</source>
        <translation>Onde chegam as leituras de um anemómetro: udp:PORTA neste computador, udp:0.0.0.0:PORTA de todos os computadores, mqtt:TÓPICO do broker MQTT, ou a página de um servidor web, como http://anemometer/wind. Vazio: nenhuma, e o vento não estaciona nada.</translation>
    </message>
    <message>
        <source>How often the page of a web server is read.</source>
        <translation>Com que frequência se lê a página de um servidor web.</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Chave</translation>
    </message>
    <message>
        <source>The name of the wind speed in a JSON message, for example wind_gust, or wind.speed for an object in an object. A plain number needs no key.</source>
        <translation>O nome da velocidade do vento numa mensagem JSON, por exemplo wind_gust, ou wind.speed para um objeto dentro de um objeto. Um simples número não precisa de chave.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
    </message>
    <message>
        <source>The unit in which the anemometer reports. The limits below are always in m/s.</source>
        <translation>A unidade em que o anemómetro indica o vento. Os limites abaixo são sempre em m/s.</translation>
    </message>
    <message>
        <source>Park above</source>
        <translation>Estacionar acima de</translation>
    </message>
    <message>
        <source>Above this wind the mount parks, and every other motion is refused. 15 m/s are 54 km/h or 29 knots.</source>
        <translation>Acima deste vento a montagem estaciona e qualquer outro movimento é recusado. 15 m/s são 54 km/h ou 29 nós.</translation>
    </message>
    <message>
        <source>Permit motion below</source>
        <translation>Permitir movimento abaixo de</translation>
    </message>
    <message>
        <source>The mount may move again after the wind was below this limit for the time below.</source>
        <translation>A montagem pode voltar a mover-se depois de o vento ficar abaixo deste limite durante o tempo indicado abaixo.</translation>
    </message>
    <message>
        <source>Calm time</source>
        <translation>Tempo de acalmia</translation>
    </message>
    <message>
        <source>Mean of a gust</source>
        <translation>Média de uma rajada</translation>
    </message>
    <message>
        <source>Without a reading for this long the wind is unknown.</source>
        <translation>Sem leitura durante este tempo o vento é desconhecido.</translation>
    </message>
    <message>
        <source>If the wind is unknown</source>
        <translation>Se o vento for desconhecido</translation>
    </message>
    <message>
        <source>&quot;tell&quot; raises an alarm. &quot;stow&quot; parks the mount as in a strong wind.</source>
        <translation>&quot;tell&quot; dá um alarme. &quot;stow&quot; estaciona a montagem como com vento forte.</translation>
    </message>
    <message>
        <source>Place in a strong wind</source>
        <translation>Lugar com vento forte</translation>
    </message>
    <message>
        <source>Where the mount parks in a strong wind: at its park position, or at the place below.</source>
        <translation>Onde a montagem estaciona com vento forte: na sua posição de estacionamento ou no lugar abaixo.</translation>
    </message>
    <message>
        <source>Azimuth of this place</source>
        <translation>Azimute deste lugar</translation>
    </message>
    <message>
        <source>Azimuth of the place in a strong wind, as an axis angle.</source>
        <translation>Azimute do lugar com vento forte, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Elevation of this place</source>
        <translation>Elevação deste lugar</translation>
    </message>
    <message>
        <source>Elevation of the place in a strong wind, as an axis angle.</source>
        <translation>Elevação do lugar com vento forte, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>How long the operator may move the mount in a strong wind after Move anyway. Then it parks again.</source>
        <translation>Durante quanto tempo o operador pode mover a montagem com vento forte depois de Mover mesmo assim. Depois ela volta a estacionar.</translation>
    </message>
    <message>
        <source>%1 is above wind.stow_above_m_s (%2)</source>
        <translation>%1 está acima de wind.stow_above_m_s (%2)</translation>
    </message>
    <message>
        <source>rotctld is not installed. Install the programs of Hamlib: libhamlib-utils on Debian and Ubuntu, hamlib on Fedora and Arch Linux</source>
        <translation>O rotctld não está instalado. Instale os programas do Hamlib: libhamlib-utils em Debian e Ubuntu, hamlib em Fedora e Arch Linux</translation>
    </message>
    <message>
        <source>Hamlib&apos;s rotctl did not answer within %1 s. Press Refresh to try again</source>
        <translation>O rotctl não respondeu em %1 s. Prima Atualizar para tentar de novo</translation>
    </message>
    <message>
        <source>Hamlib lists no rotator. Type rotctl -l in a terminal to see why</source>
        <translation>O Hamlib não lista nenhum rotor. Escreva rotctl -l num terminal para ver porquê</translation>
    </message>
    <message>
        <source>rotctld could not be started: %1</source>
        <translation>não foi possível iniciar o rotctld: %1</translation>
    </message>
    <message>
        <source>rotctld was killed or crashed</source>
        <translation>o rotctld foi terminado ou falhou</translation>
    </message>
    <message>
        <source>rotctld ended with status %1</source>
        <translation>o rotctld terminou com o estado %1</translation>
    </message>
    <message>
        <source>rotctld did not start within %1 s</source>
        <translation>o rotctld não arrancou em %1 s</translation>
    </message>
    <message>
        <source>rotctld closed the connection</source>
        <translation>o rotctld fechou a ligação</translation>
    </message>
    <message>
        <source>The answer of rotctld is: %1. Check the rotator, its power, its cable, its model (bus.name, %2) and its speed (bus.baud, %3)</source>
        <translation>A resposta do rotctld é: %1. Verifique o rotor, a alimentação, o cabo, o modelo (bus.name, %2) e a velocidade (bus.baud, %3)</translation>
    </message>
    <message>
        <source>The rotctld of Boresight does not answer. Boresight ends it and starts it again. Check the rotator and its port (bus.name, %1)</source>
        <translation>O rotctld do Boresight não responde. O Boresight termina-o e volta a iniciá-lo. Verifique o rotor e a sua porta (bus.name, %1)</translation>
    </message>
    <message>
        <source>A rotator from Hamlib&apos;s list, at this computer</source>
        <translation>Um rotor da lista do Hamlib, neste computador</translation>
    </message>
    <message>
        <source>Boresight starts rotctld for this model, and ends it.</source>
        <translation>O Boresight inicia o rotctld para este modelo e termina-o.</translation>
    </message>
    <message>
        <source>Check the power of the rotator, and the cable.</source>
        <translation>Verifique a alimentação do rotor e o cabo.</translation>
    </message>
    <message>
        <source>Compare the model and the speed with the manual of the rotator.</source>
        <translation>Compare o modelo e a velocidade com o manual do rotor.</translation>
    </message>
    <message>
        <source>park at %1 after %2 min without a command</source>
        <translation>estaciona em %1 após %2 min sem comando</translation>
    </message>
    <message>
        <source>does not park when idle: %1</source>
        <translation>não estaciona quando parada: %1</translation>
    </message>
    <message>
        <source>ends the motion because of the wind</source>
        <translation>termina o movimento por causa do vento</translation>
    </message>
    <message>
        <source>park at %1 because of the wind</source>
        <translation>estaciona em %1 por causa do vento</translation>
    </message>
    <message>
        <source>does not park in the wind: %1</source>
        <translation>não estaciona com o vento: %1</translation>
    </message>
    <message>
        <source>a reading was refused: %1</source>
        <translation>uma leitura foi recusada: %1</translation>
    </message>
    <message>
        <source>udp:PORT is expected, or udp:ADDRESS:PORT with an address of this computer</source>
        <translation>espera-se udp:PORTA, ou udp:ENDEREÇO:PORTA com um endereço deste computador</translation>
    </message>
    <message>
        <source>an address like http://anemometer/wind is expected</source>
        <translation>espera-se um endereço como http://anemometer/wind</translation>
    </message>
    <message>
        <source>udp:PORT, udp:ADDRESS:PORT, mqtt:TOPIC or http://HOST/PATH is expected</source>
        <translation>espera-se udp:PORTA, udp:ENDEREÇO:PORTA, mqtt:TÓPICO ou http://HOST/CAMINHO</translation>
    </message>
    <message>
        <source>the wind speed is not within 0 to 150 m/s</source>
        <translation>a velocidade do vento não está entre 0 e 150 m/s</translation>
    </message>
    <message>
        <source>a number, &quot;wind&quot; and a number, or a JSON object is expected</source>
        <translation>espera-se um número, &quot;wind&quot; e um número, ou um objeto JSON</translation>
    </message>
    <message>
        <source>the object has no &quot;%1&quot; (wind.key)</source>
        <translation>o objeto não tem &quot;%1&quot; (wind.key)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a model of Hamlib with its port. Write for example %2</source>
        <translation>&apos;%1&apos; não é um modelo do Hamlib com a sua porta. Escreva por exemplo %2</translation>
    </message>
    <message>
        <source>The serial port of the rotator, such as /dev/ttyUSB0, or HOST:PORT for a model that has a network connection</source>
        <translation>A porta série do rotor, como /dev/ttyUSB0, ou HOST:PORTA para um modelo com ligação de rede</translation>
    </message>
    <message>
        <source>Choose exactly the model that is on the port. Hamlib does not check it.</source>
        <translation>Escolha exatamente o modelo que está na porta. O Hamlib não o verifica.</translation>
    </message>
    <message>
        <source>Synchronise the clock by NTP or GPS. %1 moves up to %2 in a second</source>
        <translation>Sincronize o relógio por NTP ou GPS. %1 move-se até %2 num segundo</translation>
    </message>
    <message>
        <source>Everybody who reaches the MQTT broker %1 can move the mount</source>
        <translation>Quem alcançar o broker MQTT %1 pode mover a montagem</translation>
    </message>
    <message>
        <source>Boresight obeys the commands of the broker</source>
        <translation>O Boresight obedece aos comandos do broker</translation>
    </message>
    <message>
        <source>A command has at most %1 bytes.</source>
        <translation>Um comando tem no máximo %1 bytes.</translation>
    </message>
    <message>
        <source>More than %1 commands arrived in one second. Boresight ignores the rest.</source>
        <translation>Chegaram mais de %1 comandos num segundo. O Boresight ignora os restantes.</translation>
    </message>
    <message>
        <source>The profile permits only stopping and reading by MQTT (mqtt.commands).</source>
        <translation>O perfil só permite parar e ler por MQTT (mqtt.commands).</translation>
    </message>
    <message>
        <source>the tracked part of the pass of %1 begins</source>
        <translation>começa a parte seguida da passagem de %1</translation>
    </message>
    <message>
        <source>the tracked part of the pass of %1 ends</source>
        <translation>acaba a parte seguida da passagem de %1</translation>
    </message>
    <message>
        <source>Beginning of the topics &quot;state&quot; and &quot;availability&quot; that Boresight publishes, and of &quot;command&quot; and &quot;stop&quot; that it reads.</source>
        <translation>Início dos tópicos &quot;state&quot; e &quot;availability&quot; que o Boresight publica, e de &quot;command&quot; e &quot;stop&quot; que lê.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
    <message>
        <source>What the topics &quot;command&quot; and &quot;stop&quot; may do. &quot;off&quot;: nothing. &quot;stop&quot;: stop the mount and read its position. &quot;drive&quot;: move the mount, too. Everybody who may write to these topics of the broker has this right.</source>
        <translation>O que os tópicos &quot;command&quot; e &quot;stop&quot; podem fazer. &quot;off&quot;: nada. &quot;stop&quot;: parar a montagem e ler a sua posição. &quot;drive&quot;: também mover a montagem. Quem puder escrever nestes tópicos do broker tem este direito.</translation>
    </message>
    <message>
        <source>Home Assistant</source>
        <translation>Home Assistant</translation>
    </message>
    <message>
        <source>Discovery prefix</source>
        <translation>Prefixo de descoberta</translation>
    </message>
    <message>
        <source>Beginning of the topics that Home Assistant searches, as in its MQTT options.</source>
        <translation>Início dos tópicos que o Home Assistant procura, como nas suas opções de MQTT.</translation>
    </message>
    <message>
        <source>needs mqtt.publish = &quot;on&quot;</source>
        <translation>precisa de mqtt.publish = &quot;on&quot;</translation>
    </message>
    <message>
        <source>Boresight no longer reads commands by MQTT</source>
        <translation>O Boresight deixou de ler comandos por MQTT</translation>
    </message>
    <message>
        <source>the connection to the broker is lost</source>
        <translation>perdeu-se a ligação ao broker</translation>
    </message>
    <message>
        <source>By MQTT a motion needs an azimuth and an elevation, such as &quot;120.5 30&quot;, because a message may arrive twice.</source>
        <translation>Por MQTT um movimento precisa de um azimute e de uma elevação, como &quot;120.5 30&quot;, porque uma mensagem pode chegar duas vezes.</translation>
    </message>
    <message>
        <source>The broker kept this message, so it is old. Delete it at the broker. Send commands without the retain flag.</source>
        <translation>O broker guardou esta mensagem, portanto é antiga. Apague-a no broker. Envie comandos sem a marca retain.</translation>
    </message>
    <message>
        <source>The broker does not let Boresight read the topic %1. No command arrives. Permit this topic in the access list of the broker.</source>
        <translation>O broker não deixa o Boresight ler o tópico %1. Nenhum comando chega. Permita este tópico na lista de acesso do broker.</translation>
    </message>
    <message>
        <source>Check the supply, the battery and the cable. If they are right, lower the acceleration.</source>
        <translation>Verifique a alimentação, a bateria e o cabo. Se estiverem bem, baixe a aceleração.</translation>
    </message>
    <message>
        <source>Read the fault of the drive with boresightctl scan.</source>
        <translation>Leia a falha do acionamento com boresightctl scan.</translation>
    </message>
    <message>
        <source>Check the supply of the drive. Look for another program that stopped the drive.</source>
        <translation>Verifique a alimentação do acionamento. Procure outro programa que tenha parado o acionamento.</translation>
    </message>
    <message>
        <source>Check the encoder of the drive and the CAN cable.</source>
        <translation>Verifique o codificador do acionamento e o cabo CAN.</translation>
    </message>
    <message>
        <source>Check the mode and the fault of the drive. Look for another program that commands the drive.</source>
        <translation>Verifique o modo e a falha do acionamento. Procure outro programa que comande o acionamento.</translation>
    </message>
    <message>
        <source>Boresight commands this drive only from the first motion on. STOP takes the drive over and holds its axis</source>
        <translation>O Boresight só comanda este acionamento a partir do primeiro movimento. STOP assume o acionamento e mantém o seu eixo</translation>
    </message>
    <message>
        <source>Check the wires between the BNO055 of the sensor and its board. Then switch the sensor off and on</source>
        <translation>Verifique os fios entre o BNO055 do sensor e a sua placa. Depois desligue e ligue o sensor</translation>
    </message>
    <message>
        <source>Boresight allows only motions that lead out. Boresight starts no motion by itself</source>
        <translation>O Boresight só permite movimentos que saem de lá. O Boresight não inicia nenhum movimento por si</translation>
    </message>
    <message>
        <source>Jog the antenna out of this direction on the page Jog, or change the limits</source>
        <translation>Na página Manual, leve a antena para fora desta direção, ou altere os limites</translation>
    </message>
    <message>
        <source>Check rotctld, its rotator and the limits of this mount. Then track the rotator again</source>
        <translation>Verifique o rotctld, o seu rotor e os limites desta montagem. Depois volte a seguir o rotor</translation>
    </message>
    <message>
        <source>Open the page North, drop the points and take new points. To keep a point that is still right, press Use again on the page Model</source>
        <translation>Abra a página Norte, retire os pontos e tome pontos novos. Para manter um ponto que ainda está certo, prima Usar na página Modelo</translation>
    </message>
    <message>
        <source>Boresight sent a stop, and sends another stop as soon as an answer comes. Until then the rotator may run to its last target</source>
        <translation>O Boresight enviou uma paragem e envia outra assim que vier uma resposta. Até lá, o rotor pode continuar até ao seu último alvo</translation>
    </message>
    <message>
        <source>Check the power and the plugs of the board. If the board was taken away, remove it from bus.watched.</source>
        <translation>Verifique a alimentação e as fichas da placa. Se a placa foi retirada, apague-a de bus.watched.</translation>
    </message>
    <message>
        <source>Set users and passwords at the broker. Enter the user of Boresight on the page Profile (mqtt.user)</source>
        <translation>Defina utilizadores e palavras-passe no broker. Introduza o utilizador do Boresight na página Perfil (mqtt.user)</translation>
    </message>
    <message>
        <source>End the other program, then press Reconnect. If it controls another mount, give this mount another name</source>
        <translation>Termine o outro programa e prima Reconectar. Se ele controlar outra montagem, dê outro nome a esta montagem</translation>
    </message>
    <message>
        <source>Boresight counts the output as off and tries to switch it again</source>
        <translation>O Boresight considera a saída desligada e volta a tentar comutá-la</translation>
    </message>
    <message>
        <source>The wind is unknown. No reading has come since %1</source>
        <translation>O vento é desconhecido. Não chegou nenhuma leitura desde %1</translation>
    </message>
    <message>
        <source>Boresight does not park the mount</source>
        <translation>O Boresight não estaciona a montagem</translation>
    </message>
    <message>
        <source>bus &apos;socketcan:&apos; names no interface. Write for example socketcan:can0</source>
        <translation>o barramento &apos;socketcan:&apos; não indica nenhuma interface. Escreva por exemplo socketcan:can0</translation>
    </message>
    <message>
        <source>the bus names no port. Write for example %1</source>
        <translation>o barramento não indica nenhuma porta. Escreva por exemplo %1</translation>
    </message>
    <message>
        <source>the path of a port must not have control characters</source>
        <translation>o caminho de uma porta não pode ter caracteres de controlo</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an address with a port. Write for example %2</source>
        <translation>&apos;%1&apos; não é um endereço com uma porta. Escreva por exemplo %2</translation>
    </message>
    <message>
        <source>the points fit without this term</source>
        <translation>os pontos ajustam-se sem este termo</translation>
    </message>
    <message>
        <source>Point %1 is %2 away from the fit of the other points.</source>
        <translation>O ponto %1 está a %2 do ajuste dos outros pontos.</translation>
    </message>
    <message>
        <source>All points have nearly the same elevation, so azimuth offset and collimation cannot be separated. Take a point much higher or lower, or a point over the top.</source>
        <translation>Todos os pontos têm quase a mesma elevação, por isso não se distinguem o desvio do azimute e a colimação. Tome um ponto muito mais alto ou mais baixo, ou um ponto por cima do topo.</translation>
    </message>
    <message>
        <source>System calibration of the sensor is %1 of 3, but %2 is needed. Its heading is not referred to magnetic north yet.</source>
        <translation>A calibração do sistema do sensor é %1 de 3, mas são precisos %2. O seu rumo ainda não está referido ao norte magnético.</translation>
    </message>
    <message>
        <source>Are the drives powered? Is the cable plugged in at both ends? Does the bus have 120 ohm at both ends?</source>
        <translation>Os acionamentos têm alimentação? O cabo está ligado nas duas pontas? O barramento tem 120 ohm nas duas pontas?</translation>
    </message>
    <message>
        <source>only the operator may do this</source>
        <translation>só o operador pode fazer isto</translation>
    </message>
    <message>
        <source>Another client re-armed the drives while this client kept sending. Pause this client for %1 s, or send R 1.</source>
        <translation>Outro cliente rearmou os acionamentos enquanto este cliente continuava a enviar. Pause este cliente durante %1 s, ou envie R 1.</translation>
    </message>
    <message>
        <source>this client has control</source>
        <translation>este cliente tem o controlo</translation>
    </message>
    <message>
        <source>asks for a position outside the limits (%1). The mount goes to the nearest permitted position</source>
        <translation>pede uma posição fora dos limites (%1). A montagem vai para a posição permitida mais próxima</translation>
    </message>
    <message>
        <source>The cable wrap of the %1 is unknown. Enter the position of the axis. Only slow jog works.</source>
        <translation>A volta do cabo do %1 é desconhecida. Introduza a posição do eixo. Só o jog lento funciona.</translation>
    </message>
    <message>
        <source>this rotator does not have this function</source>
        <translation>este rotor não tem esta função</translation>
    </message>
    <message>
        <source>The mount tracks a target, and the change would move the mount. Press Hold first.</source>
        <translation>A montagem segue um alvo, e a alteração moveria a montagem. Prima Manter primeiro.</translation>
    </message>
    <message>
        <source>The mount moves to a target, and the change would move the mount elsewhere. Wait until it stands still, or press Hold.</source>
        <translation>A montagem move-se para um alvo, e a alteração moveria a montagem para outro lugar. Espere até estar parada, ou prima Manter.</translation>
    </message>
    <message>
        <source>Antenna &quot;%1&quot; is in use. Use the antenna &quot;main&quot; to find north.</source>
        <translation>A antena &quot;%1&quot; está em uso. Use a antena &quot;main&quot; para achar o norte.</translation>
    </message>
    <message>
        <source>The travel and the limits of the axes do not permit this direction over the top.</source>
        <translation>O curso e os limites dos eixos não permitem esta direção por cima do topo.</translation>
    </message>
    <message>
        <source>The wind was unknown. No reading came after %1</source>
        <translation>O vento era desconhecido. Não chegou nenhuma leitura depois de %1</translation>
    </message>
    <message>
        <source>steel disturbs its compass near %1 (result of the swing)</source>
        <translation>o aço perturba a bússola dele perto de %1 (resultado do giro)</translation>
    </message>
    <message>
        <source>Check the power, WiFi and cable of the sensor</source>
        <translation>Verifique a alimentação, o WiFi e o cabo do sensor</translation>
    </message>
    <message>
        <source>The difference follows the motor current, %1 per ampere (correlation %2). Move the sensor away from motors and their cables, or twist the cables</source>
        <translation>A diferença acompanha a corrente dos motores, %1 por ampere (correlação %2). Afaste o sensor dos motores e dos seus cabos, ou torça os cabos</translation>
    </message>
    <message>
        <source>The difference began while the mount moved. Check the motor current, iron near the compass, the azimuth direction of the sensor and the coupling</source>
        <translation>A diferença começou enquanto a montagem se movia. Verifique a corrente dos motores, ferro junto da bússola, o sentido de azimute do sensor e o acoplamento</translation>
    </message>
    <message>
        <source>Fix has nothing to write. Change the marked settings by hand. Each line explains how</source>
        <translation>Corrigir não tem nada a escrever. Mude à mão as configurações assinaladas. Cada linha explica como</translation>
    </message>
    <message>
        <source>Check the power and the plugs of the board, and the bus cable.</source>
        <translation>Verifique a alimentação e as fichas da placa, e o cabo do barramento.</translation>
    </message>
    <message>
        <source>Take the board off the bus. If the board drives an axis, enter its id in the profile. If it does something else, name it in bus.watched.</source>
        <translation>Retire a placa do barramento. Se a placa mover um eixo, introduza o seu id no perfil. Se fizer outra coisa, dê-lhe um nome em bus.watched.</translation>
    </message>
    <message>
        <source>Check the power and the plugs of the board, and the bus cable. If the board has another id, enter this id in the profile.</source>
        <translation>Verifique a alimentação e as fichas da placa, e o cabo do barramento. Se a placa tiver outro id, introduza esse id no perfil.</translation>
    </message>
    <message>
        <source>If you exchanged the board, check calibration and gains. If not, check whether another mount is connected.</source>
        <translation>Se trocou a placa, verifique a calibração e os ganhos. Se não, verifique se está ligada outra montagem.</translation>
    </message>
    <message>
        <source>The limit is too far out. The cable or the frame stops the axis before the drive does.</source>
        <translation>O limite está demasiado longe. O cabo ou a estrutura param o eixo antes do acionamento.</translation>
    </message>
    <message>
        <source>Without commands the drive brakes with this deceleration. Too low: the axis runs on. Too high (factory: 50 turns/s²): the stop shakes the mount.</source>
        <translation>Sem comandos, o acionamento trava com esta desaceleração. Demasiado baixa: o eixo continua. Demasiado alta (fábrica: 50 voltas/s²): a paragem sacode a montagem.</translation>
    </message>
    <message>
        <source>the line has no command for a rotator</source>
        <translation>a linha não tem nenhum comando para um rotor</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an EasyComm command</source>
        <translation>&quot;%1&quot; não é um comando EasyComm</translation>
    </message>
    <message>
        <source>The server sent: &quot;%1&quot;.</source>
        <translation>O servidor enviou: &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>The cache has no elements of this source.</source>
        <translation>A cache não tem elementos desta fonte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address</source>
        <translation>&quot;%1&quot; não é um endereço</translation>
    </message>
    <message>
        <source>the address must not contain a user name or a password</source>
        <translation>o endereço não pode conter um nome de utilizador nem uma palavra-passe</translation>
    </message>
    <message>
        <source>The answer &quot;%1&quot; is not from a rotctld</source>
        <translation>A resposta &quot;%1&quot; não é de um rotctld</translation>
    </message>
    <message>
        <source>Check the power of the rotator, the cable, and the speed (bus.baud, %1)</source>
        <translation>Verifique a alimentação do rotor, o cabo e a velocidade (bus.baud, %1)</translation>
    </message>
    <message>
        <source>this is not a GS-232 command</source>
        <translation>isto não é um comando GS-232</translation>
    </message>
    <message>
        <source> None of the possible places is near this angle.</source>
        <translation> Nenhum dos lugares possíveis fica perto deste ângulo.</translation>
    </message>
    <message>
        <source>Boresight uses the previous version: %1</source>
        <translation>O Boresight usa a versão anterior: %1</translation>
    </message>
    <message>
        <source>The drive did not report whether its position was set since then</source>
        <translation>O acionamento não comunicou se a sua posição foi definida desde então</translation>
    </message>
    <message>
        <source>The drive reports %1. No cable wrap of this angle lies within %2° of the travel. Enter the angle</source>
        <translation>O acionamento comunica %1. Nenhuma volta do cabo deste ângulo fica a menos de %2° do curso. Introduza o ângulo</translation>
    </message>
    <message>
        <source>The position that the drive reports fits only %1</source>
        <translation>A posição que o acionamento comunica só corresponde a %1</translation>
    </message>
    <message>
        <source>The nearest possible position is %1 from the position in the journal. The axis moved while Boresight did not watch it</source>
        <translation>A posição possível mais próxima está a %1 da posição do diário. O eixo moveu-se enquanto o Boresight não o vigiava</translation>
    </message>
    <message>
        <source>The axis may have moved since then. The drive cannot distinguish places %1 apart, so the journal does not show which place is right</source>
        <translation>O eixo pode ter-se movido desde então. O acionamento não distingue lugares a %1 um do outro, por isso o diário não mostra que lugar está certo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither an IP address nor a network</source>
        <translation>&quot;%1&quot; não é um endereço IP nem uma rede</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must not follow a path. Only programs of this computer reach a path</source>
        <translation>&quot;%1&quot; não pode seguir-se a um caminho. Só programas deste computador chegam a um caminho</translation>
    </message>
    <message>
        <source>A setting that requires a stop was changed while driving</source>
        <translation>Uma configuração que exige paragem foi alterada durante o acionamento</translation>
    </message>
    <message>
        <source>Firmware that Boresight does not support</source>
        <translation>Firmware que o Boresight não suporta</translation>
    </message>
    <message>
        <source>The axis did not move while no reply came. Its position is still known</source>
        <translation>O eixo não se moveu enquanto não veio resposta. A sua posição continua conhecida</translation>
    </message>
    <message>
        <source>The axis moved %1 while no reply came. Its position is still known</source>
        <translation>O eixo moveu-se %1 enquanto não veio resposta. A sua posição continua conhecida</translation>
    </message>
    <message>
        <source>The mount did not move while no reply came. Its position is still known</source>
        <translation>A montagem não se moveu enquanto não veio resposta. A sua posição continua conhecida</translation>
    </message>
    <message>
        <source>Azimuth moved %1 and elevation %2 while no reply came. The position is still known</source>
        <translation>O azimute moveu-se %1 e a elevação %2 enquanto não veio resposta. A posição continua conhecida</translation>
    </message>
    <message>
        <source>Boresight is writing the settings of the drives. Wait until this ends.</source>
        <translation>O Boresight está a escrever as configurações dos acionamentos. Espere até terminar.</translation>
    </message>
    <message>
        <source>Boresight is reading or writing the gains. Wait until this ends.</source>
        <translation>O Boresight está a ler ou a escrever os ganhos. Espere até terminar.</translation>
    </message>
    <message>
        <source>%1 is not a CAN bus. A moteus needs fdcanusb:PATH or socketcan:INTERFACE</source>
        <translation>%1 não é um barramento CAN. Um moteus precisa de fdcanusb:PATH ou socketcan:INTERFACE</translation>
    </message>
    <message>
        <source>An earlier start has used this position. It counts once.</source>
        <translation>Um arranque anterior já usou esta posição. Só conta uma vez.</translation>
    </message>
    <message>
        <source>The entered position is %1 min old. It is valid for %2 min.</source>
        <translation>A posição introduzida tem %1 min. É válida durante %2 min.</translation>
    </message>
    <message>
        <source>The entered time is in the future. Check the clock of this computer.</source>
        <translation>A hora introduzida está no futuro. Verifique o relógio deste computador.</translation>
    </message>
    <message>
        <source>Boresight did not ask for the axis position of the %1.</source>
        <translation>O Boresight não perguntou a posição do eixo do %1.</translation>
    </message>
    <message>
        <source>%1 is a list of many authorities. Name the authority that signed the certificate of the broker. With an empty mqtt.ca_file Boresight trusts the authorities of this computer</source>
        <translation>%1 é uma lista de muitas autoridades. Indique a autoridade que assinou o certificado do broker. Com mqtt.ca_file vazio, o Boresight confia nas autoridades deste computador</translation>
    </message>
    <message>
        <source>Boresight ended during this pass</source>
        <translation>O Boresight terminou durante esta passagem</translation>
    </message>
    <message>
        <source>The last pass before this start was a pass of %1. It was tracked for %2 s. It is in the night report.</source>
        <translation>A última passagem antes deste arranque foi uma passagem de %1. Foi seguida durante %2 s. Está no relatório da noite.</translation>
    </message>
    <message>
        <source>Boresight treats this as a tilted sensor. The elevation of the beam stays unchanged.</source>
        <translation>O Boresight trata isto como um sensor inclinado. A elevação do feixe não muda.</translation>
    </message>
    <message>
        <source>The mount tracks the target of a client, and the change would move the mount. Press Hold first.</source>
        <translation>A montagem segue o alvo de um cliente, e a alteração moveria a montagem. Prima Manter primeiro.</translation>
    </message>
    <message>
        <source>The profile would then be inconsistent: %1. Change this setting first.</source>
        <translation>O perfil ficaria então incoerente: %1. Mude primeiro esta configuração.</translation>
    </message>
    <message>
        <source>done, from %1 of %2 readings. Left out: %3</source>
        <translation>pronto, de %1 de %2 leituras. Ficaram de fora: %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a command. The commands are ELEVATION, AZIMUTH ELEVATION, +AZIMUTH +ELEVATION, bearing LOCATOR, bearing LOCATOR long, stop, hold, park and ?</source>
        <translation>&quot;%1&quot; não é um comando. Os comandos são ELEVATION, AZIMUTH ELEVATION, +AZIMUTH +ELEVATION, bearing LOCATOR, bearing LOCATOR long, stop, hold, park e ?</translation>
    </message>
    <message>
        <source>The step leads to %1 / %2, outside the limits.</source>
        <translation>O passo leva a %1 / %2, fora dos limites.</translation>
    </message>
    <message>
        <source>the beam misses the zenith by %1</source>
        <translation>o feixe falha o zénite por %1</translation>
    </message>
    <message>
        <source>a part of the line is not a number</source>
        <translation>uma parte da linha não é um número</translation>
    </message>
    <message>
        <source>the text is not a JSON object</source>
        <translation>o texto não é um objeto JSON</translation>
    </message>
    <message>
        <source>What turns the axis. Each axis may have its own driver. &quot;gs232&quot; is a Yaesu GS-232A, a GS-232B or a compatible box. &quot;rotctld&quot; is any rotator that Hamlib drives. &quot;simple&quot; is simulated only: a rotator of whole degrees without a watchdog. With &quot;none&quot; the mount has no such axis.</source>
        <translation>O que roda o eixo. Cada eixo pode ter o seu próprio controlador. &quot;gs232&quot; é um Yaesu GS-232A, um GS-232B ou uma caixa compatível. &quot;rotctld&quot; é qualquer rotor que o Hamlib controla. &quot;simple&quot; é só simulado: um rotor de graus inteiros sem watchdog. Com &quot;none&quot; a montagem não tem esse eixo.</translation>
    </message>
    <message>
        <source>Whether Home Assistant finds the mount by itself. Needs mqtt.publish. The buttons for STOP and park appear only if mqtt.commands permits them.</source>
        <translation>Se o Home Assistant encontra a montagem sozinho. Precisa de mqtt.publish. Os botões de STOP e de estacionar só aparecem se mqtt.commands os permitir.</translation>
    </message>
    <message>
        <source>Name of the antenna that tracks the satellite. &quot;main&quot; is the antenna of the table mount. Without this key Boresight uses the antenna chosen by hand.</source>
        <translation>Nome da antena que segue o satélite. &quot;main&quot; é a antena da tabela mount. Sem esta chave o Boresight usa a antena escolhida à mão.</translation>
    </message>
    <message>
        <source>Number of the satellite in the catalogue of NORAD.</source>
        <translation>Número do satélite no catálogo NORAD.</translation>
    </message>
    <message>
        <source>A note of one line, such as frequency and polarisation.</source>
        <translation>Uma nota de uma linha, como frequência e polarização.</translation>
    </message>
    <message>
        <source>Satellites with older elements are not tracked. The error of a low orbit grows by 1 to 3 km a day.</source>
        <translation>Os satélites com elementos mais antigos não são seguidos. O erro de uma órbita baixa cresce 1 a 3 km por dia.</translation>
    </message>
    <message>
        <source>The mount aims at the place where the tracked satellite will be after this time.</source>
        <translation>A montagem aponta para o lugar onde o satélite seguido estará depois deste tempo.</translation>
    </message>
    <message>
        <source>Which refraction of the air Boresight applies. By kind: Sun, Moon and planets like light, radio sources like radio waves, satellites not at all. The other values hold for all targets. AOS and LOS of satellites stay geometric.</source>
        <translation>Que refração do ar o Boresight aplica. By kind: Sol, Lua e planetas como a luz, fontes de rádio como as ondas de rádio, satélites sem refração. Os outros valores aplicam-se a todos os alvos. AOS e LOS dos satélites ficam geométricos.</translation>
    </message>
    <message>
        <source>How Boresight receives the position of a balloon or a rocket to track: by UDP on a port of this computer, or by a topic of the MQTT broker.</source>
        <translation>Como o Boresight recebe a posição de um balão ou foguetão para seguir: por UDP numa porta deste computador, ou por um tópico do broker MQTT.</translation>
    </message>
    <message>
        <source>Only reports with this call sign count. Empty: every report counts. Then only one balloon or rocket may fly.</source>
        <translation>Só contam as comunicações com este indicativo. Vazio: conta qualquer comunicação. Nesse caso só pode voar um balão ou foguetão.</translation>
    </message>
    <message>
        <source>Name of the antenna. &quot;main&quot; is the antenna that the table mount describes.</source>
        <translation>Nome da antena. &quot;main&quot; é a antena que a tabela mount descreve.</translation>
    </message>
    <message>
        <source>How far its beam points clockwise of the main beam, measured on the sky at any elevation. A negative value is counter-clockwise.</source>
        <translation>Quanto o seu feixe aponta no sentido horário em relação ao feixe principal, medido no céu a qualquer elevação. Um valor negativo é no sentido anti-horário.</translation>
    </message>
    <message>
        <source>%1 antennas are too many. The maximum is %2.</source>
        <translation>%1 antenas são demasiadas. O máximo é %2.</translation>
    </message>
    <message>
        <source>An output that is on only while the beam is on its target: file:PATH, mqtt:TOPIC, command:PROGRAM with its arguments, dtr:PORT or rts:PORT. Use it as the interlock of the transmitter. Empty: none.</source>
        <translation>Uma saída que só está ligada enquanto o feixe está no alvo: file:CAMINHO, mqtt:TÓPICO, command:PROGRAMA com os seus argumentos, dtr:PORTA ou rts:PORTA. Use-a como encravamento do emissor. Vazio: nenhuma.</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>não definido</translation>
    </message>
    <message>
        <source>%1 points are too many. The maximum is %2.</source>
        <translation>%1 pontos são demasiados. O máximo é %2.</translation>
    </message>
    <message>
        <source>%1 keep-outs are too many. The maximum is %2.</source>
        <translation>%1 zonas proibidas são demasiadas. O máximo é %2.</translation>
    </message>
    <message>
        <source>Counter-clockwise side of the keep-out.</source>
        <translation>Lado anti-horário da zona proibida.</translation>
    </message>
    <message>
        <source>Clockwise side of the keep-out. A keep-out from 350 to 10 passes through north.</source>
        <translation>Lado horário da zona proibida. Uma zona proibida de 350 a 10 passa pelo norte.</translation>
    </message>
    <message>
        <source>Lower side of the keep-out.</source>
        <translation>Lado inferior da zona proibida.</translation>
    </message>
    <message>
        <source>Upper side of the keep-out.</source>
        <translation>Lado superior da zona proibida.</translation>
    </message>
    <message>
        <source>A program that runs when a pass of the armed schedule begins. It has the same form as &quot;Program before AOS&quot;.</source>
        <translation>Um programa que corre quando começa uma passagem da agenda armada. Tem a mesma forma que &quot;Programa antes do AOS&quot;.</translation>
    </message>
    <message>
        <source>A program that runs when a pass of the armed schedule ends, also if the pass ends early. It has the same form as &quot;Program before AOS&quot;.</source>
        <translation>Um programa que corre quando termina uma passagem da agenda armada, também se a passagem terminar antes do tempo. Tem a mesma forma que &quot;Programa antes do AOS&quot;.</translation>
    </message>
    <message>
        <source>A program that runs when a fault ends the armed schedule. It has the same form as &quot;Program before AOS&quot;.</source>
        <translation>Um programa que corre quando uma falha termina a agenda armada. Tem a mesma forma que &quot;Programa antes do AOS&quot;.</translation>
    </message>
    <message>
        <source>Whether somebody has checked that each axis turns in the direction of this file. Until then every motion is short and slow. Without this key a real mount is unconfirmed.</source>
        <translation>Se alguém verificou que cada eixo gira no sentido deste ficheiro. Até lá, cada movimento é curto e lento. Sem esta chave, uma montagem real está por confirmar.</translation>
    </message>
    <message>
        <source>The state of the drives after the program ends. &quot;hold&quot; needs servo.timeout_mode 10 in the drives. Without this mode they only damp.</source>
        <translation>O estado dos acionamentos depois de o programa terminar. &quot;hold&quot; precisa de servo.timeout_mode 10 nos acionamentos. Sem este modo só amortecem.</translation>
    </message>
    <message>
        <source>Which client moves the mount. &quot;first&quot;: the first client, until it has sent no motion command for 10 s. &quot;last&quot;: the client with the latest motion command, as with Hamlib. &quot;locked&quot;: only the client of &quot;Locked to&quot;.</source>
        <translation>Que cliente move a montagem. &quot;first&quot;: o primeiro cliente, até não enviar nenhum comando de movimento durante 10 s. &quot;last&quot;: o cliente com o último comando de movimento, como no Hamlib. &quot;locked&quot;: só o cliente de &quot;Reservado a&quot;.</translation>
    </message>
    <message>
        <source>The wind must stay below the lower limit for this time. Then the mount may move, but nothing moves by itself.</source>
        <translation>O vento tem de ficar abaixo do limite inferior durante este tempo. Depois a montagem pode mover-se, mas nada se move por si.</translation>
    </message>
    <message>
        <source>%1 serves this path already</source>
        <translation>%1 já serve este caminho</translation>
    </message>
    <message>
        <source>is not a program for rotators (%1)</source>
        <translation>não é um programa para rotores (%1)</translation>
    </message>
    <message>
        <source>%1 exists and is not a link to a terminal</source>
        <translation>%1 existe e não é uma ligação a um terminal</translation>
    </message>
    <message>
        <source>%1 exists and is not a socket</source>
        <translation>%1 existe e não é um socket</translation>
    </message>
    <message>
        <source>On this computer use the option -t %1. Boresight itself uses %2.</source>
        <translation>Neste computador use a opção -t %1. O próprio Boresight usa a %2.</translation>
    </message>
    <message>
        <source>the position is the site of the mount</source>
        <translation>a posição é o local da montagem</translation>
    </message>
    <message>
        <source>another rotator was requested, and refused</source>
        <translation>foi pedido outro rotor, e recusado</translation>
    </message>
    <message>
        <source>the table of %1 has ended, and the mount holds</source>
        <translation>a tabela de %1 terminou, e a montagem mantém a posição</translation>
    </message>
    <message>
        <source>Boresight connected to the broker again</source>
        <translation>O Boresight voltou a ligar-se ao broker</translation>
    </message>
    <message>
        <source>End the other program, or give this mount another name in its profile</source>
        <translation>Termine o outro programa, ou dê a esta montagem outro nome no seu perfil</translation>
    </message>
    <message>
        <source>The previous output has not answered yet.</source>
        <translation>A saída anterior ainda não respondeu.</translation>
    </message>
    <message>
        <source>%1 stands still and needs %2 Nm, %3 % of the %4 Nm allowed: more than the %5 Nm of weight and friction</source>
        <translation>o %1 está parado e precisa de %2 Nm, %3 % dos %4 Nm permitidos: mais do que os %5 Nm do peso e do atrito</translation>
    </message>
    <message>
        <source>INTERPOLATION is &quot;%1&quot;. Boresight supports HERMITE, LAGRANGE and LINEAR.</source>
        <translation>INTERPOLATION é &quot;%1&quot;. O Boresight suporta HERMITE, LAGRANGE e LINEAR.</translation>
    </message>
    <message>
        <source>The object is &quot;%1&quot;, but the object above is &quot;%2&quot;. Write a file for each object.</source>
        <translation>O objeto é &quot;%1&quot;, mas o objeto acima é &quot;%2&quot;. Escreva um ficheiro para cada objeto.</translation>
    </message>
    <message>
        <source>The rows of %1 at %2 are too uneven to interpolate between them.</source>
        <translation>As linhas de %1 às %2 são demasiado irregulares para interpolar entre elas.</translation>
    </message>
    <message>
        <source>the wind speed is not a number</source>
        <translation>a velocidade do vento não é um número</translation>
    </message>
    <message>
        <source>Boresight takes each message of the topic %1 for a command (mqtt.commands). Choose another topic</source>
        <translation>O Boresight trata cada mensagem do tópico %1 como um comando (mqtt.commands). Escolha outro tópico</translation>
    </message>
    <message>
        <source>Boresight already uses the topic %1. Choose another topic</source>
        <translation>O Boresight já usa o tópico %1. Escolha outro tópico</translation>
    </message>
    <message>
        <source>applied despite this warning: %1</source>
        <translation>aplicado apesar deste aviso: %1</translation>
    </message>
    <message>
        <source>Steel disturbs the compass at this heading (result of the swing). Measure at another heading.</source>
        <translation>O aço perturba a bússola neste rumo (resultado do giro). Meça noutro rumo.</translation>
    </message>
    <message>
        <source>The %1 is %2 away from its target, more than half the beam width</source>
        <translation>O %1 está a %2 do seu alvo, mais de metade da largura do feixe</translation>
    </message>
    <message>
        <source>Permit more starts on the page Profile (rotator.max_starts_per_min), or point less exactly.</source>
        <translation>Permita mais arranques na página Perfil (rotator.max_starts_per_min), ou aponte com menos exatidão.</translation>
    </message>
    <message>
        <source>A datagram with a forged sender can move the mount through %1</source>
        <translation>Um datagrama com remetente falsificado pode mover a montagem através de %1</translation>
    </message>
    <message>
        <source>Use this listener only in a network that you trust, or let it listen on 127.0.0.1 (listeners.list on the page Profile)</source>
        <translation>Use esta escuta só numa rede em que confia, ou ponha-a em 127.0.0.1 (listeners.list na página Perfil)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no IP address and port. An example: tcp:127.0.0.1:4534</source>
        <translation>&quot;%1&quot; não indica um endereço IP e uma porta. Um exemplo: tcp:127.0.0.1:4534</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a place to listen. tcp:ADDRESS:PORT, udp:ADDRESS:PORT, pty:/PATH or unix:/PATH is expected</source>
        <translation>&quot;%1&quot; não é um lugar onde escutar. Espera-se tcp:ENDEREÇO:PORTA, udp:ENDEREÇO:PORTA, pty:/CAMINHO ou unix:/CAMINHO</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not served at &quot;%2&quot;. &quot;pst&quot; and &quot;n1mm&quot; have a place like udp:127.0.0.1:12000, and no other protocol has one</source>
        <translation>&quot;%1&quot; não é servido em &quot;%2&quot;. &quot;pst&quot; e &quot;n1mm&quot; têm um lugar como udp:127.0.0.1:12000, e nenhum outro protocolo o tem</translation>
    </message>
    <message>
        <source>&quot;pst&quot; answers to the port after its own. Choose a port below %1</source>
        <translation>&quot;pst&quot; responde para a porta a seguir à sua. Escolha uma porta abaixo de %1</translation>
    </message>
    <message>
        <source>&quot;rotor=&quot; is followed by the name of a rotor in N1MM, at the end of a line of n1mm</source>
        <translation>a &quot;rotor=&quot; segue-se o nome de um rotor do N1MM, no fim de uma linha de n1mm</translation>
    </message>
    <message>
        <source>The place %1 is already used. Each listener needs its own.</source>
        <translation>O lugar %1 já está em uso. Cada escuta precisa do seu.</translation>
    </message>
    <message>
        <source>Rare motor starts</source>
        <translation>Poucos arranques dos motores</translation>
    </message>
    <message>
        <source>&quot;on&quot; starts the motors of a rotator seldom. Choose it if the control box only switches them on and off. &quot;off&quot; sends each step of the target.</source>
        <translation>&quot;on&quot; arranca raramente os motores do rotor. Escolha-o se a caixa de controlo apenas os liga e desliga. &quot;off&quot; envia cada passo do alvo.</translation>
    </message>
    <message>
        <source>Dead-band</source>
        <translation>Banda morta</translation>
    </message>
    <message>
        <source>With rare motor starts, a motor starts when a tracked target is this far away. Beside a keep-out, the horizon and the Sun there is no dead-band. 0: 0.15 of the beam width, at most 5°.</source>
        <translation>Com poucos arranques dos motores, um motor arranca quando um alvo seguido está a esta distância. Junto de uma zona proibida, do horizonte e do Sol não há banda morta. 0: 0,15 da largura do feixe, no máximo 5°.</translation>
    </message>
    <message>
        <source>Most motor starts per minute</source>
        <translation>Máximo de arranques do motor por minuto</translation>
    </message>
    <message>
        <source>With rare motor starts, a motor starts at most this often in a minute while a target is tracked. The limit does not apply to a slew, to a jog, and beside a keep-out, the horizon or the Sun. 0: no limit.</source>
        <translation>Com poucos arranques dos motores, um motor arranca no máximo este número de vezes por minuto enquanto um alvo é seguido. O limite não se aplica a uma deslocação, ao movimento manual, nem junto de uma zona proibida, do horizonte ou do Sol. 0: sem limite.</translation>
    </message>
    <message>
        <source>Coast</source>
        <translation>Deslize</translation>
    </message>
    <message>
        <source>With rare motor starts, how far an axis goes on when its motor is switched off. An axis that is nearer to its target stays there. 0: as Boresight measures it.</source>
        <translation>Com poucos arranques dos motores, quanto um eixo ainda avança depois de o motor ser desligado. Um eixo que está mais perto do alvo fica onde está. 0: como o Boresight o mede.</translation>
    </message>
    <message>
        <source>Listeners for programs that do not speak rotctld. Each has a protocol (&quot;gs232a&quot;, &quot;gs232b&quot;, &quot;easycomm1&quot;, &quot;easycomm2&quot;, &quot;easycomm3&quot;, &quot;pairs&quot;, &quot;pst&quot; or &quot;n1mm&quot;), the right to &quot;drive&quot; or only to &quot;read&quot;, and a place: &quot;gs232b drive tcp:127.0.0.1:4534&quot;, &quot;gs232a read pty:/tmp/rotator&quot;, &quot;pairs drive unix:/tmp/pairs&quot; or &quot;pst drive udp:127.0.0.1:12000&quot;. Addresses and networks that may connect by TCP or UDP can follow, and for N1MM &quot;rotor=NAME&quot;. Empty: none.</source>
        <translation>Escutas para programas que não falam rotctld. Cada uma tem um protocolo (&quot;gs232a&quot;, &quot;gs232b&quot;, &quot;easycomm1&quot;, &quot;easycomm2&quot;, &quot;easycomm3&quot;, &quot;pairs&quot;, &quot;pst&quot; ou &quot;n1mm&quot;), o direito de mover (&quot;drive&quot;) ou só de ler (&quot;read&quot;), e um lugar: &quot;gs232b drive tcp:127.0.0.1:4534&quot;, &quot;gs232a read pty:/tmp/rotator&quot;, &quot;pairs drive unix:/tmp/pairs&quot; ou &quot;pst drive udp:127.0.0.1:12000&quot;. Podem seguir-se endereços e redes que se podem ligar por TCP ou UDP e, para o N1MM, &quot;rotor=NOME&quot;. Vazio: nenhuma.</translation>
    </message>
    <message>
        <source>cannot listen on UDP %1:%2: %3</source>
        <translation>não é possível escutar em UDP %1:%2: %3</translation>
    </message>
    <message>
        <source>was silent for %1 s</source>
        <translation>esteve em silêncio durante %1 s</translation>
    </message>
    <message>
        <source>is not disconnected, because it is read-only. Its next datagram would make it a client that may move the mount.</source>
        <translation>não é desligado, porque só pode ler. O seu próximo datagrama torná-lo-ia um cliente que pode mover a montagem.</translation>
    </message>
    <message>
        <source>Boresight knows no such command of N1MM.</source>
        <translation>O Boresight não conhece este comando do N1MM.</translation>
    </message>
    <message>
        <source>names no rotor</source>
        <translation>não indica nenhum rotor</translation>
    </message>
    <message>
        <source>for the rotor &quot;%1&quot;</source>
        <translation>para o rotor &quot;%1&quot;</translation>
    </message>
    <message>
        <source>This is no datagram for PstRotator.</source>
        <translation>Isto não é um datagrama para o PstRotator.</translation>
    </message>
    <message>
        <source>The datagram has the field &quot;%1&quot; twice.</source>
        <translation>O datagrama tem o campo &quot;%1&quot; duas vezes.</translation>
    </message>
    <message>
        <source>Boresight does not obey the field &quot;%1&quot; with the value &quot;%2&quot;.</source>
        <translation>O Boresight não obedece ao campo &quot;%1&quot; com o valor &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>The datagram asks for two motions.</source>
        <translation>O datagrama pede dois movimentos.</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>nada a fazer</translation>
    </message>
    <message>
        <source>A datagram has at most %1 bytes.</source>
        <translation>Um datagrama tem no máximo %1 bytes.</translation>
    </message>
    <message>
        <source>This computer slept or was blocked less than %1 s ago. The command may be old. Send it again.</source>
        <translation>Este computador dormiu ou esteve bloqueado há menos de %1 s. O comando pode ser antigo. Envie-o de novo.</translation>
    </message>
    <message>
        <source>Use new time</source>
        <translation>Usar nova hora</translation>
    </message>
    <message>
        <source>The clock of this computer was set by %1 s%2</source>
        <translation>O relógio deste computador foi acertado em %1 s%2</translation>
    </message>
    <message>
        <source>Press Use new time if the new time is right. Otherwise correct the clock</source>
        <translation>Prima &quot;Usar nova hora&quot; se a nova hora estiver certa. Caso contrário, corrija o relógio</translation>
    </message>
    <message>
        <source>nothing writes the file. Open Astronomical Data in WSJT-X</source>
        <translation>nada escreve o ficheiro. Abra Astronomical Data no WSJT-X</translation>
    </message>
    <message>
        <source>no source of motion accepts this request</source>
        <translation>nenhuma fonte de movimento aceita este pedido</translation>
    </message>
    <message>
        <source>%1 would be %2 away</source>
        <translation>%1 ficaria a %2</translation>
    </message>
    <message>
        <source>%1 has no direction at the new time</source>
        <translation>%1 não tem direção à nova hora</translation>
    </message>
    <message>
        <source>%1: This is a pipe or a device. Name a file or a folder.</source>
        <translation>%1: Isto é um pipe ou um dispositivo. Indique um ficheiro ou uma pasta.</translation>
    </message>
    <message>
        <source>The magnetic model %1 was valid until %2. Its declination is less exact each year. Get the present World Magnetic Model (.COF).</source>
        <translation>O modelo magnético %1 foi válido até %2. A sua declinação é menos exata a cada ano. Obtenha o atual World Magnetic Model (.COF).</translation>
    </message>
    <message>
        <source>The magnetic model %1 is valid until %2. Get the next model before then.</source>
        <translation>O modelo magnético %1 é válido até %2. Obtenha o modelo seguinte antes disso.</translation>
    </message>
    <message>
        <source>The journal does not prove the cable wrap, because the position became doubtful later</source>
        <translation>O diário não prova a volta do cabo, porque a posição se tornou duvidosa depois</translation>
    </message>
    <message>
        <source>other computers could move the mount by UDP. Add the permitted addresses. Or listen on 127.0.0.1, or use the right &quot;read&quot;</source>
        <translation>outros computadores poderiam mover a montagem por UDP. Acrescente os endereços permitidos. Ou escute em 127.0.0.1, ou use o direito &quot;read&quot;</translation>
    </message>
    <message>
        <source>The station is closing.</source>
        <translation>A estação está a fechar.</translation>
    </message>
    <message>
        <source>Update the firmware. Report the fault to the maker</source>
        <translation>Atualize o firmware. Comunique a falha ao fabricante</translation>
    </message>
    <message>
        <source>Report the fault to the maker</source>
        <translation>Comunique a falha ao fabricante</translation>
    </message>
    <message>
        <source>There is nothing to clear. If this happens often, lower the acceleration</source>
        <translation>Não há nada a limpar. Se isto acontecer muitas vezes, baixe a aceleração</translation>
    </message>
    <message>
        <source>the drive contradicts %1. The nearest position that the drive permits is %2. If that position is wrong, another tool has set the position of the drive. Switch the power of the drive off and on</source>
        <translation>o acionamento contradiz %1. A posição mais próxima que o acionamento permite é %2. Se essa posição estiver errada, outra ferramenta definiu a posição do acionamento. Desligue e volte a ligar a alimentação do acionamento</translation>
    </message>
    <message>
        <source>Boresight connected to the broker, or continued after a pause, less than %1 s ago. This command may be old. Send it again.</source>
        <translation>O Boresight ligou-se ao broker, ou continuou depois de uma pausa, há menos de %1 s. Este comando pode ser antigo. Envie-o de novo.</translation>
    </message>
    <message>
        <source>%1 sent another command</source>
        <translation>%1 enviou outro comando</translation>
    </message>
    <message>
        <source>The clock of this computer was set, so tracking stopped. Check the clock, then track the %1 again.</source>
        <translation>O relógio deste computador foi acertado, por isso o seguimento parou. Verifique o relógio e depois siga de novo: %1.</translation>
    </message>
    <message>
        <source>overrode this warning by Apply anyway: %1</source>
        <translation>ignorou este aviso com &quot;Aplicar mesmo assim&quot;: %1</translation>
    </message>
    <message>
        <source>the settings of Hamlib have no effect, because Boresight starts no rotctld for %1</source>
        <translation>as definições do Hamlib não têm efeito, porque o Boresight não inicia nenhum rotctld para %1</translation>
    </message>
    <message>
        <source>Remove them, or give them to the rotctld that you start yourself, with its option -C.</source>
        <translation>Retire-as, ou dê-as ao rotctld que inicia à parte, com a opção -C.</translation>
    </message>
    <message>
        <source>names %1 twice</source>
        <translation>indica %1 duas vezes</translation>
    </message>
    <message>
        <source>%1: %2 points. A horizon has 1 to %3 points</source>
        <translation>%1: %2 pontos. Um horizonte tem de 1 a %3 pontos</translation>
    </message>
    <message>
        <source>Settings of Hamlib</source>
        <translation>Definições do Hamlib</translation>
    </message>
    <message>
        <source>Further settings for the rotctld that Boresight starts for a model of Hamlib, such as &quot;stop_bits=2&quot; or &quot;min_az=-90&quot;. &quot;rotctl -m MODEL -L&quot; lists their names.</source>
        <translation>Outras definições para o rotctld que o Boresight inicia para um modelo do Hamlib, como &quot;stop_bits=2&quot; ou &quot;min_az=-90&quot;. &quot;rotctl -m MODELO -L&quot; lista os seus nomes.</translation>
    </message>
    <message>
        <source>NAME=VALUE without blanks and commas is expected, like &quot;min_az=-90&quot;</source>
        <translation>Espera-se NOME=VALOR sem espaços nem vírgulas, como &quot;min_az=-90&quot;</translation>
    </message>
    <message>
        <source>Boresight sets %1 itself. Change %2 instead</source>
        <translation>O próprio Boresight define %1. Mude antes %2</translation>
    </message>
    <message>
        <source>%1 needs a number</source>
        <translation>%1 precisa de um número</translation>
    </message>
    <message>
        <source>Hamlib refuses a setting of bus.hamlib_settings. &quot;rotctl -m %1 -L&quot; lists the settings of this model</source>
        <translation>O Hamlib recusa uma definição de bus.hamlib_settings. &quot;rotctl -m %1 -L&quot; lista as definições deste modelo</translation>
    </message>
    <message>
        <source>Boresight already uses the time of this computer.</source>
        <translation>O Boresight já usa a hora deste computador.</translation>
    </message>
    <message>
        <source>uses the new time of this computer (%1 s)</source>
        <translation>usa a nova hora deste computador (%1 s)</translation>
    </message>
    <message>
        <source>Boresight is closing. It stops the mount</source>
        <translation>O Boresight está a fechar. Para a montagem</translation>
    </message>
    <message>
        <source>This is not a file. Choose a file.</source>
        <translation>Isto não é um ficheiro. Escolha um ficheiro.</translation>
    </message>
    <message>
        <source>There is no such file. Check its path.</source>
        <translation>Este ficheiro não existe. Verifique o caminho.</translation>
    </message>
    <message>
        <source>The file has the key %1 twice in one segment.</source>
        <translation>O ficheiro tem a chave %1 duas vezes num segmento.</translation>
    </message>
    <message>
        <source>Use a table with later times.</source>
        <translation>Use uma tabela com horas posteriores.</translation>
    </message>
    <message>
        <source>%1 satellites have that name, among them %2. Enter the number.</source>
        <translation>%1 satélites têm esse nome, entre eles %2. Introduza o número.</translation>
    </message>
    <message>
        <source>The axis was %1 away from its set-point. Put the gains back. Check that nothing blocks the axis</source>
        <translation>O eixo estava a %1 do seu valor de referência. Reponha os ganhos. Verifique que nada bloqueia o eixo</translation>
    </message>
    <message>
        <source>Boresight does not support the offset of an antenna. Set the offset to 0 in N1MM, and enter it in Boresight as the direction of the beam.</source>
        <translation>O Boresight não suporta o desvio de uma antena. Ponha o desvio a 0 no N1MM e introduza-o no Boresight como direção do feixe.</translation>
    </message>
    <message>
        <source>The brake output %1 does not work: %2</source>
        <translation>A saída do travão %1 não funciona: %2</translation>
    </message>
    <message>
        <source>Boresight stops the mount and refuses every motion</source>
        <translation>O Boresight para a montagem e recusa todo o movimento</translation>
    </message>
    <message>
        <source>The brake may be set or released: secure the antenna. Check the output, or choose another one (brake.output on the page Profile)</source>
        <translation>O travão pode estar aplicado ou solto: segure a antena. Verifique a saída, ou escolha outra (brake.output na página Perfil)</translation>
    </message>
    <message>
        <source>brake output: %1</source>
        <translation>saída do travão: %1</translation>
    </message>
    <message>
        <source>The brake output does not work: %1. Check the output.</source>
        <translation>A saída do travão não funciona: %1. Verifique a saída.</translation>
    </message>
    <message>
        <source>The brake is not set yet. Wait until nothing has moved for %1 s.</source>
        <translation>O travão ainda não está aplicado. Espere até nada se mover durante %1 s.</translation>
    </message>
    <message>
        <source>The brake output (brake.output) can only be changed while the brake is set. Hold the mount, and wait until it stands still and the brake is set.</source>
        <translation>A saída do travão (brake.output) só pode ser mudada com o travão aplicado. Mantenha a montagem na posição e espere até que esteja parada e o travão aplicado.</translation>
    </message>
    <message>
        <source>Time to open or to close</source>
        <translation>Tempo para abrir ou fechar</translation>
    </message>
    <message>
        <source>Set after</source>
        <translation>Aplicar após</translation>
    </message>
    <message>
        <source>The brakes are set when nothing has moved for this time. After STOP and after a fault they are set as soon as the mount stands still.</source>
        <translation>Os travões são aplicados quando nada se moveu durante este tempo. Depois de STOP e depois de uma falha são aplicados assim que a montagem estiver parada.</translation>
    </message>
    <message>
        <source>is also the transmit output (transmit.output)</source>
        <translation>é também a saída de transmissão (transmit.output)</translation>
    </message>
    <message>
        <source>the adapter is gone. Plug it in again</source>
        <translation>o adaptador desapareceu. Ligue-o de novo</translation>
    </message>
    <message>
        <source>the adapter is gone. Plug it in again, in any socket. Boresight finds it as %1</source>
        <translation>o adaptador desapareceu. Ligue-o de novo, em qualquer tomada. O Boresight encontra-o como %1</translation>
    </message>
    <message>
        <source>the interface was removed. Plug the adapter in again</source>
        <translation>a interface foi retirada. Ligue o adaptador de novo</translation>
    </message>
    <message>
        <source>The profile has a self-locking gearbox, so it asks for brake (15).</source>
        <translation>O perfil tem uma caixa redutora autobloqueante, por isso pede travão (15).</translation>
    </message>
    <message>
        <source>%1: The file is larger than 4 MB</source>
        <translation>%1: O ficheiro tem mais de 4 MB</translation>
    </message>
    <message>
        <source>the sensor or the positions already use this topic</source>
        <translation>o sensor ou as posições já usam este tópico</translation>
    </message>
    <message>
        <source>ends the tracking, because the clock was set: %1</source>
        <translation>termina o seguimento, porque o relógio foi acertado: %1</translation>
    </message>
    <message>
        <source>The brake output does not work: %1. The brake may be open. Secure the antenna, then empty brake.output on the page Profile.</source>
        <translation>A saída do travão não funciona: %1. O travão pode estar aberto. Segure a antena e depois esvazie brake.output na página Perfil.</translation>
    </message>
    <message>
        <source>uses the port of the transmit output (transmit.output)</source>
        <translation>usa a porta da saída de transmissão (transmit.output)</translation>
    </message>
    <message>
        <source>The mount no longer tracks another rotator: %1</source>
        <translation>A montagem já não segue outro rotor: %1</translation>
    </message>
    <message>
        <source>The mount tracks the directions of the file, in steps of 0.1°</source>
        <translation>A montagem segue as direções do ficheiro, em passos de 0,1°</translation>
    </message>
    <message>
        <source>Boresight still uses the old time, so the mount does not jump</source>
        <translation>O Boresight ainda usa a hora antiga, para que a montagem não salte</translation>
    </message>
    <message>
        <source>Boresight obeys every datagram with a permitted sender address</source>
        <translation>O Boresight obedece a qualquer datagrama com um endereço de remetente permitido</translation>
    </message>
    <message>
        <source>The mount is not parked. Boresight does not move it by itself and refuses every motion except Park</source>
        <translation>A montagem não está estacionada. O Boresight não a move por si e recusa qualquer movimento exceto Estacionar</translation>
    </message>
    <message>
        <source>The operator permitted motion until %2. Then the mount parks</source>
        <translation>O operador permitiu o movimento até às %2. Depois a montagem estaciona</translation>
    </message>
    <message>
        <source>Keep its power switch in reach. If Boresight or the cable fails, the rotator still completes its last step</source>
        <translation>Tenha o interruptor dele ao alcance. Se o Boresight ou o cabo falhar, o rotor ainda completa o seu último passo</translation>
    </message>
    <message>
        <source>the clock of this computer has its old time again</source>
        <translation>o relógio deste computador tem de novo a hora antiga</translation>
    </message>
    <message>
        <source>%1 has control. It connects for each command. It sent its last command %2.</source>
        <translation>%1 tem o controlo. Liga-se para cada comando. Enviou o seu último comando %2.</translation>
    </message>
    <message>
        <source>The azimuth cable cannot be unwrapped further in this direction.</source>
        <translation>O cabo do azimute não pode ser mais desenrolado neste sentido.</translation>
    </message>
    <message>
        <source>types to the control box: %1</source>
        <translation>escreve para a caixa de controlo: %1</translation>
    </message>
    <message>
        <source>The mount tracks a target. Press Hold first.</source>
        <translation>A montagem segue um alvo. Prima primeiro Manter.</translation>
    </message>
    <message>
        <source>Check the elevation offset and the mounting of the sensor. Check the elevation zero and the coupling</source>
        <translation>Verifique o desvio de elevação e a montagem do sensor. Verifique o zero da elevação e o acoplamento</translation>
    </message>
    <message>
        <source>Check the azimuth offset and the mounting of the sensor. Look for iron or a motor current near the compass. Check the azimuth zero</source>
        <translation>Verifique o desvio de azimute e a montagem do sensor. Procure ferro ou uma corrente de motor perto da bússola. Verifique o zero do azimute</translation>
    </message>
    <message>
        <source>The factory limits are ±3.6°. With them every motion ends in fault 39.</source>
        <translation>Os limites de fábrica são ±3,6°. Com eles todos os movimentos acabam na falha 39.</translation>
    </message>
    <message>
        <source>The limit lies inside the travel. The drive stops with fault 39 where the profile permits motion.</source>
        <translation>O limite está dentro do curso. O acionamento para com a falha 39 onde o perfil permite o movimento.</translation>
    </message>
    <message>
        <source>At this distance below servo.max_voltage the motor begins to turn braking energy into heat.</source>
        <translation>A esta distância abaixo de servo.max_voltage o motor começa a transformar a energia de travagem em calor.</translation>
    </message>
    <message>
        <source>The highest speed of a command that has no speed of its own. The factory sets no limit.</source>
        <translation>A velocidade máxima de um comando que não tem velocidade própria. De fábrica não há limite.</translation>
    </message>
    <message>
        <source>%1: The file is larger than %2 MB. Split it.</source>
        <translation>%1: O ficheiro tem mais de %2 MB. Divida-o.</translation>
    </message>
    <message>
        <source>After this line the box waits for an answer, and takes the questions of Boresight for it. Close Boresight, and send this line with a terminal program.</source>
        <translation>Depois desta linha a caixa espera por uma resposta, e toma por ela as perguntas do Boresight. Feche o Boresight e envie esta linha com um programa de terminal.</translation>
    </message>
    <message>
        <source>system %1, gyroscope %2, accelerometer %3, magnetometer %4</source>
        <translation>sistema %1, giroscópio %2, acelerómetro %3, magnetómetro %4</translation>
    </message>
    <message>
        <source>Calibration of its sensor, 3 is best: %1</source>
        <translation>Calibração do seu sensor, 3 é o melhor: %1</translation>
    </message>
    <message>
        <source>The box calibrates its sensor and answers nothing else. Move the antenna until all digits of the box are 3. They are %1</source>
        <translation>A caixa calibra o seu sensor e não responde a mais nada. Mova a antena até todos os dígitos da caixa serem 3. São %1</translation>
    </message>
    <message>
        <source>The box is a GS-232A, a GS-232B, a compatible box or the ESP32 relay controller.</source>
        <translation>A caixa é um GS-232A, um GS-232B, uma caixa compatível ou o controlador de relés ESP32.</translation>
    </message>
    <message>
        <source>This line moves the rotator past the limits of Boresight. Use the page Jog.</source>
        <translation>Esta linha move o rotor sem os limites do Boresight. Use a página Manual.</translation>
    </message>
    <message>
        <source>The supply fell below the limit of the gate driver, or the hardware is damaged</source>
        <translation>A alimentação desceu abaixo do limite do controlador de portas, ou o hardware está danificado</translation>
    </message>
    <message>
        <source>An internal timing check of the drive failed</source>
        <translation>Falhou uma verificação interna dos tempos do acionamento</translation>
    </message>
    <message>
        <source>An error of the drive&apos;s firmware, detected only with its checks enabled</source>
        <translation>Um erro do firmware do acionamento, detetado só com as suas verificações ativas</translation>
    </message>
    <message>
        <source>The limit ends when the board cools down. If the board gets hotter, fault 38 follows</source>
        <translation>O limite acaba quando a placa arrefecer. Se a placa aquecer mais, segue-se a falha 38</translation>
    </message>
    <message>
        <source>The limit ends when the motor cools down. If the motor gets hotter, fault 38 follows</source>
        <translation>O limite acaba quando o motor arrefecer. Se o motor aquecer mais, segue-se a falha 38</translation>
    </message>
    <message>
        <source>Limited by servopos.position_min/max</source>
        <translation>Limitada por servopos.position_min/max</translation>
    </message>
    <message>
        <source>The motor turns braking energy into heat, so that the bus voltage stays in its limits</source>
        <translation>O motor transforma a energia de travagem em calor, para que a tensão do barramento fique dentro dos limites</translation>
    </message>
    <message>
        <source>releases the bus to other tools. Drives that are on continue in their time-out mode</source>
        <translation>liberta o barramento para outras ferramentas. Os acionamentos ligados continuam no seu modo de fim de tempo</translation>
    </message>
    <message>
        <source>The clock of this computer was set, and Boresight still uses the old time. Press Use new time or correct the clock before you track the %1 here.</source>
        <translation>O relógio deste computador foi acertado, e o Boresight ainda usa a hora antiga. Prima &quot;Usar nova hora&quot; ou corrija o relógio antes de seguir aqui o alvo %1.</translation>
    </message>
    <message>
        <source>The antenna points at the Sun. Never look along the beam or a sight tube without a solar filter. Watch the heat at the feed</source>
        <translation>A antena aponta para o Sol. Nunca olhe ao longo do feixe ou por um tubo de mira sem filtro solar. Vigie o calor no iluminador</translation>
    </message>
    <message>
        <source>The clock of this computer was set. If the old time was wrong, drop the points of the Sun and the Moon that were taken with it</source>
        <translation>O relógio deste computador foi acertado. Se a hora antiga estava errada, elimine os pontos do Sol e da Lua que foram obtidos com ela</translation>
    </message>
    <message>
        <source>By the model in force the beam is %1° away from the target. If the target was not centred, drop point %2</source>
        <translation>Segundo o modelo em vigor o feixe está a %1° do alvo. Se o alvo não estava centrado, elimine o ponto %2</translation>
    </message>
    <message>
        <source>This result is unreliable. %1 To use it, press Apply anyway.</source>
        <translation>Este resultado não é fiável. %1 Para o usar, prima Aplicar mesmo assim.</translation>
    </message>
    <message>
        <source>the previous output has not answered for %1 s</source>
        <translation>a saída anterior não responde há %1 s</translation>
    </message>
    <message>
        <source>has %1 bytes, with its commas. rotctld accepts at most %2 bytes. Remove a setting.</source>
        <translation>tem %1 bytes, com as suas vírgulas. O rotctld aceita no máximo %2 bytes. Retire uma definição.</translation>
    </message>
    <message>
        <source>The mount moves to the new direction of the Moon at most once in this time. At 1 s it moves all the time.</source>
        <translation>A montagem move-se para a nova direção da Lua no máximo uma vez neste tempo. Com 1 s move-se o tempo todo.</translation>
    </message>
    <message>
        <source>The mount moves only when its distance from the Moon is this part of the beam width. 0: only the interval counts.</source>
        <translation>A montagem só se move quando a sua distância à Lua é esta parte da largura do feixe. 0: só conta o intervalo.</translation>
    </message>
    <message>
        <source>A position is refused if the balloon or rocket would have to fly faster than this to reach it.</source>
        <translation>Uma posição é recusada se o balão ou o foguete tivesse de voar mais depressa do que isto para a alcançar.</translation>
    </message>
    <message>
        <source>The time that the brakes need to open or to close. Boresight waits for this time before it moves the mount. When Boresight ends, it waits again before it releases the drives.</source>
        <translation>O tempo de que os travões precisam para abrir ou fechar. O Boresight espera este tempo antes de mover a montagem. Quando o Boresight termina, espera outra vez antes de libertar os acionamentos.</translation>
    </message>
    <message>
        <source>Boresight uses the mean of the readings of this time. Weather services define a gust by 3 s. 0: Boresight uses each reading.</source>
        <translation>O Boresight usa a média das leituras deste tempo. Os serviços meteorológicos definem uma rajada por 3 s. 0: o Boresight usa cada leitura.</translation>
    </message>
    <message>
        <source>no answer to the typed line</source>
        <translation>sem resposta à linha escrita</translation>
    </message>
    <message>
        <source>answers the typed line: %1</source>
        <translation>responde à linha escrita: %1</translation>
    </message>
    <message>
        <source>The control box does not answer.</source>
        <translation>A caixa de controlo não responde.</translation>
    </message>
    <message>
        <source>The answer to the last line is awaited. Wait a second.</source>
        <translation>Espera-se a resposta à última linha. Aguarde um segundo.</translation>
    </message>
    <message>
        <source>(no answer)</source>
        <translation>(sem resposta)</translation>
    </message>
    <message>
        <source>A line has 1 to %1 letters without accents, digits and signs.</source>
        <translation>Uma linha tem 1 a %1 letras sem acentos, algarismos e sinais.</translation>
    </message>
    <message>
        <source>its Moon is %1 away from the computed Moon. The locator in WSJT-X or the site is wrong</source>
        <translation>a sua Lua está a %1 da Lua calculada. O localizador no WSJT-X ou o local está errado</translation>
    </message>
    <message>
        <source>%1 reached %2 %3. It rises by %4 %3/min and will reach %5 %3 at %6</source>
        <translation>%1 atingiu %2 %3. Sobe %4 %3/min e atingirá %5 %3 às %6</translation>
    </message>
    <message>
        <source>%1 fell to %2 %3. It falls by %4 %3/min and will reach %5 %3 at %6</source>
        <translation>%1 desceu a %2 %3. Desce %4 %3/min e atingirá %5 %3 às %6</translation>
    </message>
    <message>
        <source>The mount ran into the end switch at %1</source>
        <translation>A montagem embateu no fim de curso: %1</translation>
    </message>
    <message>
        <source>Boresight stopped the mount and permits no motion into this end</source>
        <translation>O Boresight parou a montagem e não permite movimento para este fim</translation>
    </message>
    <message>
        <source>Compare the shown angle with the antenna. Check the travel of the axis, its limits and the switch.</source>
        <translation>Compare o ângulo mostrado com a antena. Verifique o curso do eixo, os seus limites e o fim de curso.</translation>
    </message>
    <message>
        <source>The end switch at %1 is pressed</source>
        <translation>O fim de curso está premido: %1</translation>
    </message>
    <message>
        <source>Boresight permits no motion into this end</source>
        <translation>O Boresight não permite movimento para este fim</translation>
    </message>
    <message>
        <source>Jog the axis away from this end. If the axis is not at this end, check the switch and its wires</source>
        <translation>Afaste o eixo deste fim com o comando manual. Se o eixo não está neste fim, verifique o fim de curso e os seus fios</translation>
    </message>
    <message>
        <source>The end switch at %1 cannot be read: %2</source>
        <translation>O fim de curso não pode ser lido: %1: %2</translation>
    </message>
    <message>
        <source>The switch counts as pressed, so Boresight permits no motion into this end</source>
        <translation>O fim de curso conta como premido, por isso o Boresight não permite movimento para este fim</translation>
    </message>
    <message>
        <source>Check the input %3 and its wires, or choose another one (End switches on the page Profile)</source>
        <translation>Verifique a entrada %3 e os seus fios, ou escolha outra (Fins de curso na página Perfil)</translation>
    </message>
    <message>
        <source>Boresight ignores this switch, as the profile says (end_switches.when_unread)</source>
        <translation>O Boresight ignora este fim de curso, como diz o perfil (end_switches.when_unread)</translation>
    </message>
    <message>
        <source>the id of a board and a pin are expected, like moteus:1:aux1.0. The ports are aux1 and aux2, the pins 0 to 4</source>
        <translation>espera-se o id de uma placa e um pino, como moteus:1:aux1.0. As portas são aux1 e aux2, os pinos de 0 a 4</translation>
    </message>
    <message>
        <source>moteus:ID:aux1.PIN, mqtt:TOPIC, cts:PORT, dsr:PORT, dcd:PORT or ri:PORT is expected</source>
        <translation>espera-se moteus:ID:aux1.PINO, mqtt:TÓPICO, cts:PORTA, dsr:PORTA, dcd:PORTA ou ri:PORTA</translation>
    </message>
    <message>
        <source>on or off is expected</source>
        <translation>espera-se on ou off</translation>
    </message>
    <message>
        <source>goes the long way, %1, because the cable ends at axis %2</source>
        <translation>vai pelo caminho longo, %1, porque o cabo acaba em %2 do eixo</translation>
    </message>
    <message>
        <source>cable end, long way %1</source>
        <translation>fim do cabo, caminho longo %1</translation>
    </message>
    <message>
        <source>the upper end of the azimuth</source>
        <translation>fim superior do azimute</translation>
    </message>
    <message>
        <source>the lower end of the azimuth</source>
        <translation>fim inferior do azimute</translation>
    </message>
    <message>
        <source>the upper end of the elevation</source>
        <translation>fim superior da elevação</translation>
    </message>
    <message>
        <source>the lower end of the elevation</source>
        <translation>fim inferior da elevação</translation>
    </message>
    <message>
        <source>no reading has come yet</source>
        <translation>ainda não chegou nenhuma leitura</translation>
    </message>
    <message>
        <source>The end switch at %1 cannot be read (%2), so it counts as pressed</source>
        <translation>O fim de curso não pode ser lido (%1: %2), por isso conta como premido</translation>
    </message>
    <message>
        <source>%1. Move the axis the other way.</source>
        <translation>%1. Mova o eixo no outro sentido.</translation>
    </message>
    <message>
        <source>%1 Boresight tries again at least every 30 s</source>
        <translation>%1 O Boresight tenta de novo pelo menos a cada 30 s</translation>
    </message>
    <message>
        <source>a message about a switch was refused: %1</source>
        <translation>uma mensagem sobre um fim de curso foi recusada: %1</translation>
    </message>
    <message>
        <source>no message for %1 s</source>
        <translation>nenhuma mensagem há %1 s</translation>
    </message>
    <message>
        <source>board %1 has not replied yet</source>
        <translation>a placa %1 ainda não respondeu</translation>
    </message>
    <message>
        <source>board %1 does not reply</source>
        <translation>a placa %1 não responde</translation>
    </message>
    <message>
        <source>this mount has no such pins</source>
        <translation>esta montagem não tem esses pinos</translation>
    </message>
    <message>
        <source>the steps have no effect, because this driver has none</source>
        <translation>os passos não têm efeito, porque este controlador não tem nenhuns</translation>
    </message>
    <message>
        <source>Set %1.steps_per_turn to 0.</source>
        <translation>Ponha %1.steps_per_turn a 0.</translation>
    </message>
    <message>
        <source>the sensor, the positions, the wind or an end switch already use the topic %1</source>
        <translation>o sensor, as posições, o vento ou um fim de curso já usam o tópico %1</translation>
    </message>
    <message>
        <source>must be 0 or at least %1</source>
        <translation>tem de ser 0 ou pelo menos %1</translation>
    </message>
    <message>
        <source>is also the input of %1. Each switch needs an input of its own</source>
        <translation>é também a entrada de outro: %1. Cada fim de curso precisa de uma entrada própria</translation>
    </message>
    <message>
        <source>is a pin of a moteus, but no axis has a moteus</source>
        <translation>é um pino de um moteus, mas nenhum eixo tem um moteus</translation>
    </message>
    <message>
        <source>uses the port of the transmit output or of the brake output</source>
        <translation>usa a porta da saída de transmissão ou da saída do travão</translation>
    </message>
    <message>
        <source>The input of the switch at this end of the axis: moteus:ID:aux1.PIN, mqtt:TOPIC, cts:PORT, dsr:PORT, dcd:PORT or ri:PORT. While the switch is pressed, nothing moves the axis further into this end. Empty: no switch.</source>
        <translation>A entrada do fim de curso neste fim do eixo: moteus:ID:aux1.PINO, mqtt:TÓPICO, cts:PORTA, dsr:PORTA, dcd:PORTA ou ri:PORTA. Enquanto está premido, nada move o eixo mais para este fim. Vazio: não há fim de curso.</translation>
    </message>
    <message>
        <source>Azimuth, lower end</source>
        <translation>Azimute, fim inferior</translation>
    </message>
    <message>
        <source>Azimuth, upper end</source>
        <translation>Azimute, fim superior</translation>
    </message>
    <message>
        <source>Elevation, lower end</source>
        <translation>Elevação, fim inferior</translation>
    </message>
    <message>
        <source>Elevation, upper end</source>
        <translation>Elevação, fim superior</translation>
    </message>
    <message>
        <source>Pressed when</source>
        <translation>Premido quando</translation>
    </message>
    <message>
        <source>What the input reads while its switch is pressed. &quot;off&quot; suits a switch that opens its circuit when it is pressed: a broken wire then counts as pressed.</source>
        <translation>O que a entrada indica enquanto o fim de curso está premido. &quot;off&quot; serve para um fim de curso que abre o seu circuito quando é premido: um fio partido conta então como premido.</translation>
    </message>
    <message>
        <source>If it cannot be read</source>
        <translation>Se não puder ser lido</translation>
    </message>
    <message>
        <source>Both raise an alarm. &quot;pressed&quot; also permits no motion into the end of a switch that cannot be read.</source>
        <translation>Ambos dão um alarme. &quot;pressed&quot; também não permite movimento para o fim de um fim de curso que não pode ser lido.</translation>
    </message>
    <message>
        <source>MQTT: without a message for this long the switch cannot be read. The sender has to repeat its messages more often than this.</source>
        <translation>MQTT: sem mensagem durante este tempo o fim de curso não pode ser lido. O emissor tem de repetir as suas mensagens mais vezes do que isto.</translation>
    </message>
    <message>
        <source>Steps per turn</source>
        <translation>Passos por volta</translation>
    </message>
    <message>
        <source>The number of positions of a rotator in a full turn, from the position 0: 866, or 1024 for 512 steps in 180°. Boresight sends it only to these. A box that counts coarser keeps its own steps. A moteus has no steps. 0: as the box counts.</source>
        <translation>O número de posições de um rotor numa volta completa, a partir da posição 0: 866, ou 1024 para 512 passos em 180°. O Boresight só o envia para estas. Uma caixa que conta mais grosso mantém os seus próprios passos. Um moteus não tem passos. 0: como a caixa conta.</translation>
    </message>
    <message>
        <source>the port hangs</source>
        <translation>a porta não responde</translation>
    </message>
    <message>
        <source>%1 has no lines CTS, DSR, DCD and RI</source>
        <translation>%1 não tem linhas CTS, DSR, DCD e RI</translation>
    </message>
    <message>
        <source>Boresight knows no satellites. Add their elements.</source>
        <translation>O Boresight não conhece satélites. Acrescente os seus elementos.</translation>
    </message>
    <message>
        <source>A pass is planned for a mount with two axes. This mount has one axis.</source>
        <translation>Uma passagem é planeada para uma montagem com dois eixos. Esta montagem tem um eixo.</translation>
    </message>
    <message>
        <source>Cleared: %1</source>
        <translation>Terminado: %1</translation>
    </message>
    <message>
        <source>The travel %1…%2 does not fit this rotator. It counts whole degrees of %3…%4. Change %5.travel_min_deg and %5.travel_max_deg in the profile.</source>
        <translation>O curso %1…%2 não serve para este rotor. Ele conta graus inteiros de %3…%4. Mude %5.travel_min_deg e %5.travel_max_deg no perfil.</translation>
    </message>
    <message>
        <source>The travel %1…%2 does not fit this rotator. This rotator reports a heading and no cable wrap. So its travel may be at most %3 wide. Change azimuth.travel_min_deg and azimuth.travel_max_deg in the profile.</source>
        <translation>O curso %1…%2 não serve para este rotor. Este rotor indica um rumo e nenhuma volta do cabo. Por isso o seu curso pode ter no máximo %3. Mude azimuth.travel_min_deg e azimuth.travel_max_deg no perfil.</translation>
    </message>
    <message>
        <source>trims the tracked target by %1 in X, %2 in Y</source>
        <translation>compensa o alvo seguido em %1 de X, %2 de Y</translation>
    </message>
    <message>
        <source>An X/Y mount has no cable to unwrap.</source>
        <translation>Uma montagem X/Y não tem cabo para desenrolar.</translation>
    </message>
    <message>
        <source>An X/Y mount has no elevation axis to lower. Go to a direction instead.</source>
        <translation>Uma montagem X/Y não tem um eixo de elevação para baixar. Vá antes para uma direção.</translation>
    </message>
    <message>
        <source>An X/Y mount cannot be calibrated here. The profile has the direction of its X axis (mount.x_axis_deg) and the zero of each axis.</source>
        <translation>Uma montagem X/Y não pode ser calibrada aqui. O perfil tem a direção do eixo X (mount.x_axis_deg) e o zero de cada eixo.</translation>
    </message>
    <message>
        <source>An X/Y mount needs no plan: it has no cable to unwrap, and no keyhole at the zenith.</source>
        <translation>Uma montagem X/Y não precisa de plano: não tem cabo para desenrolar nem zona cega no zénite.</translation>
    </message>
    <message>
        <source>X axis %1 below limit %2</source>
        <translation>Eixo X %1 abaixo do limite %2</translation>
    </message>
    <message>
        <source>X axis %1 above limit %2</source>
        <translation>Eixo X %1 acima do limite %2</translation>
    </message>
    <message>
        <source>Y axis %1 below limit %2</source>
        <translation>Eixo Y %1 abaixo do limite %2</translation>
    </message>
    <message>
        <source>Y axis %1 above limit %2</source>
        <translation>Eixo Y %1 acima do limite %2</translation>
    </message>
    <message>
        <source>X axis %1 outside limits %2…%3</source>
        <translation>Eixo X %1 fora dos limites %2…%3</translation>
    </message>
    <message>
        <source>Y axis %1 outside limits %2…%3</source>
        <translation>Eixo Y %1 fora dos limites %2…%3</translation>
    </message>
    <message>
        <source>%1 lies too close to the horizon (%2)</source>
        <translation>%1 está demasiado perto do horizonte (%2)</translation>
    </message>
    <message>
        <source>the X axis limit %1</source>
        <translation>o limite do eixo X %1</translation>
    </message>
    <message>
        <source>the Y axis limit %1</source>
        <translation>o limite do eixo Y %1</translation>
    </message>
    <message>
        <source>An X/Y mount needs a moteus drive for each axis.</source>
        <translation>Uma montagem X/Y precisa de um acionamento moteus em cada eixo.</translation>
    </message>
    <message>
        <source>The X axis of an X/Y mount turns by at most %1 to each side.</source>
        <translation>O eixo X de uma montagem X/Y roda no máximo %1 para cada lado.</translation>
    </message>
    <message>
        <source>The Y axis of an X/Y mount turns by at most %1 to each side.</source>
        <translation>O eixo Y de uma montagem X/Y roda no máximo %1 para cada lado.</translation>
    </message>
    <message>
        <source>An X/Y mount has no pointing terms. Set 0, and enter the zero of each axis as azimuth.offset_deg and elevation.offset_deg.</source>
        <translation>Uma montagem X/Y não tem termos de apontamento. Ponha 0 e introduza o zero de cada eixo em azimuth.offset_deg e elevation.offset_deg.</translation>
    </message>
    <message>
        <source>On an X/Y mount every antenna points where the main antenna points. Set both offsets to 0.</source>
        <translation>Numa montagem X/Y todas as antenas apontam para onde aponta a antena principal. Ponha os dois desvios a 0.</translation>
    </message>
    <message>
        <source>Boresight cannot use an orientation sensor on an X/Y mount. Set &quot;none&quot;.</source>
        <translation>O Boresight não pode usar um sensor de orientação numa montagem X/Y. Escolha &quot;none&quot;.</translation>
    </message>
    <message>
        <source>&quot;continuous&quot; counts turns of the azimuth axis, which an X/Y mount does not have.</source>
        <translation>&quot;continuous&quot; conta voltas do eixo de azimute, que uma montagem X/Y não tem.</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometria</translation>
    </message>
    <message>
        <source>What the two axes turn about. &quot;az-el&quot;: azimuth and elevation. &quot;x-y&quot;: the lower axis X is horizontal and carries the upper axis Y. At X 0° and Y 0° the beam points to the zenith. All settings of the azimuth axis are then those of X, and those of the elevation axis are those of Y.</source>
        <translation>Em torno de que rodam os dois eixos. &quot;az-el&quot;: azimute e elevação. &quot;x-y&quot;: o eixo inferior X é horizontal e suporta o eixo superior Y. Com X 0° e Y 0° o feixe aponta para o zénite. Todas as definições do eixo de azimute são então as de X, e as do eixo de elevação são as de Y.</translation>
    </message>
    <message>
        <source>Direction of the X axis</source>
        <translation>Direção do eixo X</translation>
    </message>
    <message>
        <source>Only for &quot;x-y&quot;: true azimuth of the X axis. 0 is north-south, 90 is east-west. A positive Y leans the beam to this azimuth, a positive X to the azimuth 90° clockwise of it.</source>
        <translation>Só para &quot;x-y&quot;: azimute verdadeiro do eixo X. 0 é norte-sul, 90 é este-oeste. Um Y positivo inclina o feixe para este azimute, um X positivo para o azimute 90° no sentido dos ponteiros do relógio a partir deste.</translation>
    </message>
    <message>
        <source>This station moves a real mount, which shows no faults on request. Start it with --simulate.</source>
        <translation>Esta estação move uma montagem real, que não mostra falhas a pedido. Inicie-a com --simulate.</translation>
    </message>
    <message>
        <source>This simulated mount has no moteus drive, and only these show faults on request.</source>
        <translation>Esta montagem simulada não tem nenhum acionamento moteus, e só estes mostram falhas a pedido.</translation>
    </message>
    <message>
        <source>The azimuth of this mount has no simulated moteus drive.</source>
        <translation>O azimute desta montagem não tem nenhum acionamento moteus simulado.</translation>
    </message>
    <message>
        <source>The elevation of this mount has no simulated moteus drive.</source>
        <translation>A elevação desta montagem não tem nenhum acionamento moteus simulado.</translation>
    </message>
    <message>
        <source>The drive of the third axis (%1) reports fault %2</source>
        <translation>O acionamento do terceiro eixo (%1) indica a falha %2</translation>
    </message>
    <message>
        <source>Remove the cause, then press Re-arm.</source>
        <translation>Elimine a causa e prima Rearmar.</translation>
    </message>
    <message>
        <source>The drive of the third axis (%1) does not reply</source>
        <translation>O acionamento do terceiro eixo (%1) não responde</translation>
    </message>
    <message>
        <source>Check the power and the plugs of the board with the id %2. If there is no such axis, set third_axis.id to 0.</source>
        <translation>Verifique a alimentação e as fichas da placa com o id %2. Se esse eixo não existir, ponha third_axis.id a 0.</translation>
    </message>
    <message>
        <source>This mount has no control box that takes typed lines.</source>
        <translation>Esta montagem não tem nenhuma caixa de controlo que aceite linhas escritas.</translation>
    </message>
    <message>
        <source>This mount has no third axis. To use one, enter its board in the profile (third_axis.id).</source>
        <translation>Esta montagem não tem terceiro eixo. Para usar um, indique a sua placa no perfil (third_axis.id).</translation>
    </message>
    <message>
        <source>The rate is above the limit of the third axis (%1°/s).</source>
        <translation>A velocidade está acima do limite do terceiro eixo (%1°/s).</translation>
    </message>
    <message>
        <source>The third axis is at the end of its travel (%1).</source>
        <translation>O terceiro eixo está no fim do seu curso (%1).</translation>
    </message>
    <message>
        <source>The jog of the third axis was ended. Release the button and press it again.</source>
        <translation>O movimento manual do terceiro eixo foi terminado. Solte o botão e prima-o de novo.</translation>
    </message>
    <message>
        <source>jogs the third axis (%1)</source>
        <translation>move manualmente o terceiro eixo (%1)</translation>
    </message>
    <message>
        <source>the jog ends: %1</source>
        <translation>o movimento manual termina: %1</translation>
    </message>
    <message>
        <source>is not held any more: %1</source>
        <translation>já não é mantido: %1</translation>
    </message>
    <message>
        <source>its keep-alive did not come</source>
        <translation>o seu sinal de vida não chegou</translation>
    </message>
    <message>
        <source>re-arms the third axis, and nothing moves</source>
        <translation>rearma o terceiro eixo, e nada se move</translation>
    </message>
    <message>
        <source>The pin is no input: %1 of board %2 is %3. Set it to %4 with moteus tview and store it</source>
        <translation>O pino não é uma entrada: %1 da placa %2 é %3. Ponha-o a %4 com o moteus tview e guarde-o</translation>
    </message>
    <message>
        <source>its drive stopped replying</source>
        <translation>o seu acionamento deixou de responder</translation>
    </message>
    <message>
        <source>its drive has a fault</source>
        <translation>o seu acionamento tem uma falha</translation>
    </message>
    <message>
        <source>the watchdog of its drive expired</source>
        <translation>o watchdog do seu acionamento expirou</translation>
    </message>
    <message>
        <source>its drive was switched off by its power or by another program</source>
        <translation>o seu acionamento foi desligado por falta de alimentação ou por outro programa</translation>
    </message>
    <message>
        <source>its drive does not obey</source>
        <translation>o seu acionamento não obedece</translation>
    </message>
    <message>
        <source>its drive reports no position</source>
        <translation>o seu acionamento não indica a posição</translation>
    </message>
    <message>
        <source>its position jumped</source>
        <translation>a sua posição saltou</translation>
    </message>
    <message>
        <source>it does not follow, so something blocks it</source>
        <translation>não segue, portanto algo o bloqueia</translation>
    </message>
    <message>
        <source>Boresight is reading the board of the third axis. Wait a moment.</source>
        <translation>O Boresight está a ler a placa do terceiro eixo. Espere um momento.</translation>
    </message>
    <message>
        <source>The board of the third axis has the register map %1. Boresight knows the register map %2. Update the firmware of the board.</source>
        <translation>A placa do terceiro eixo tem o mapa de registos %1. O Boresight conhece o mapa de registos %2. Atualize o firmware da placa.</translation>
    </message>
    <message>
        <source>The drive of the third axis does not reply. Check its power and its plugs.</source>
        <translation>O acionamento do terceiro eixo não responde. Verifique a sua alimentação e as suas fichas.</translation>
    </message>
    <message>
        <source>The drive of the third axis has a fault: %1. Remove the cause and press Re-arm.</source>
        <translation>O acionamento do terceiro eixo tem uma falha: %1. Elimine a causa e prima Rearmar.</translation>
    </message>
    <message>
        <source>The third axis reports no position. Check its encoder.</source>
        <translation>O terceiro eixo não indica a posição. Verifique o seu codificador.</translation>
    </message>
    <message>
        <source>The board of the third axis does not know its position after power-up. Set the position with moteus tview (d exact). If the axis has an encoder of its own, set third_axis.power_up_position to &quot;trusted&quot;.</source>
        <translation>A placa do terceiro eixo não conhece a sua posição depois de ligada. Defina a posição com o moteus tview (d exact). Se o eixo tiver um codificador próprio, ponha third_axis.power_up_position a &quot;trusted&quot;.</translation>
    </message>
    <message>
        <source>needs an axis with the driver &quot;moteus&quot;, whose bus it shares</source>
        <translation>precisa de um eixo com o controlador &quot;moteus&quot;, cujo barramento partilha</translation>
    </message>
    <message>
        <source>The board with the id %1 turns azimuth or elevation</source>
        <translation>A placa com o id %1 move o azimute ou a elevação</translation>
    </message>
    <message>
        <source>The board with the id %1 is in bus.watched, too</source>
        <translation>A placa com o id %1 também está em bus.watched</translation>
    </message>
    <message>
        <source>must be larger than third_axis.travel_min_deg (%1)</source>
        <translation>tem de ser maior do que third_axis.travel_min_deg (%1)</translation>
    </message>
    <message>
        <source>The travel must lie within half a turn of the controller to each side of its zero. After power-up the controller knows this turn only.</source>
        <translation>O curso tem de ficar dentro de meia volta do controlador para cada lado do seu zero. Depois de ligado, o controlador só conhece esta volta.</translation>
    </message>
    <message>
        <source>CAN id of the moteus controller of a further axis, such as the polarisation. Boresight shows this axis and jogs it. No client and no target moves it. 0: there is none.</source>
        <translation>Id CAN do controlador moteus de um outro eixo, como o da polarização. O Boresight mostra este eixo e move-o manualmente. Nenhum cliente e nenhum alvo o move. 0: não existe.</translation>
    </message>
    <message>
        <source>The name of this axis in the window.</source>
        <translation>O nome deste eixo na janela.</translation>
    </message>
    <message>
        <source>Turns that the controller counts for one turn of the axis. 1: the controller has the gear ratio itself, and counts turns of the axis.</source>
        <translation>Voltas que o controlador conta por cada volta do eixo. 1: o próprio controlador tem a relação de engrenagem e conta voltas do eixo.</translation>
    </message>
    <message>
        <source>&quot;trusted&quot; if the position after power-up is always right: an encoder on the axis. Otherwise the axis is jogged only while the controller reports a referenced output.</source>
        <translation>&quot;trusted&quot; se a posição depois de ligar está sempre certa: um codificador no eixo. Senão, o eixo só é movido enquanto o controlador indicar uma saída referenciada.</translation>
    </message>
    <message>
        <source>Upper end of the permitted travel, as an axis angle.</source>
        <translation>Fim superior do curso permitido, como ângulo do eixo.</translation>
    </message>
    <message>
        <source>Jog rate</source>
        <translation>Velocidade manual</translation>
    </message>
    <message>
        <source>The speed of a jog of this axis.</source>
        <translation>A velocidade de um movimento manual deste eixo.</translation>
    </message>
    <message>
        <source>Home run</source>
        <translation>Procurar referência</translation>
    </message>
    <message>
        <source>The rotator makes its home run</source>
        <translation>O rotor procura a sua referência</translation>
    </message>
    <message>
        <source>The box drives the axes to its own switches. The limits of Boresight do not hold meanwhile</source>
        <translation>A caixa leva os eixos aos seus próprios interruptores. Entretanto os limites do Boresight não valem</translation>
    </message>
    <message>
        <source>Watch the antenna and its cable. STOP ends the run.</source>
        <translation>Observe a antena e o seu cabo. STOP termina a procura.</translation>
    </message>
    <message>
        <source>The home run failed: %1</source>
        <translation>A procura da referência falhou: %1</translation>
    </message>
    <message>
        <source>Boresight ended it. The count of the axes is as it was</source>
        <translation>O Boresight terminou-a. A contagem dos eixos ficou como estava</translation>
    </message>
    <message>
        <source>Make the home run at the box, if the box has one. Then compare the angles with the antenna.</source>
        <translation>Procure a referência na caixa, se a caixa o permitir. Depois compare os ângulos com a antena.</translation>
    </message>
    <message>
        <source>The mount met the end switch at %1 at %2, but this switch is at %3</source>
        <translation>A montagem encontrou o fim de curso (%1) a %2, mas este fim de curso está a %3</translation>
    </message>
    <message>
        <source>Boresight stopped the mount. The axis has lost steps, so its shown angle is wrong</source>
        <translation>O Boresight parou a montagem. O eixo perdeu passos, por isso o ângulo mostrado está errado</translation>
    </message>
    <message>
        <source>file:PATH, mqtt:TOPIC, command:PROGRAM, dtr:PORT, rts:PORT or moteus:ID:aux1.PIN is expected</source>
        <translation>espera-se file:CAMINHO, mqtt:TÓPICO, command:PROGRAMA, dtr:PORTA, rts:PORTA ou moteus:ID:aux1.PINO</translation>
    </message>
    <message>
        <source>The mount has brakes, and the rotator does not wait for them in a home run.</source>
        <translation>A montagem tem travões, e o rotor não espera por eles ao procurar a referência.</translation>
    </message>
    <message>
        <source>starts a home run of the rotator</source>
        <translation>inicia a procura da referência do rotor</translation>
    </message>
    <message>
        <source>%1 (output)</source>
        <translation>%1 (saída)</translation>
    </message>
    <message>
        <source>This pin releases the brakes (brake.output), so it must be an output. Set it with moteus tview: conf set %1 %2; conf write.</source>
        <translation>Este pino solta os travões (brake.output), por isso tem de ser uma saída. Defina-o com o moteus tview: conf set %1 %2; conf write.</translation>
    </message>
    <message>
        <source>The end switch at %1 was met at %2, but it is at %3</source>
        <translation>O fim de curso (%1) foi encontrado a %2, mas está a %3</translation>
    </message>
    <message>
        <source>the pin was switched off. Was board %1 without power?</source>
        <translation>o pino foi desligado. A placa %1 esteve sem alimentação?</translation>
    </message>
    <message>
        <source>the pin was switched on. Does another program use board %1?</source>
        <translation>o pino foi ligado. Outro programa usa a placa %1?</translation>
    </message>
    <message>
        <source>the line to board %1 is closed</source>
        <translation>a linha para a placa %1 está fechada</translation>
    </message>
    <message>
        <source>this rotator has no command for a home run</source>
        <translation>este rotor não tem um comando para procurar a referência</translation>
    </message>
    <message>
        <source>is also the input of an end switch</source>
        <translation>é também a entrada de um fim de curso</translation>
    </message>
    <message>
        <source>a pin of a moteus can only be a brake output (brake.output)</source>
        <translation>um pino de um moteus só pode ser uma saída de travão (brake.output)</translation>
    </message>
    <message>
        <source>An output that is on while the brakes of the axes are released: file:PATH, mqtt:TOPIC, command:PROGRAM with its arguments, dtr:PORT, rts:PORT or moteus:ID:aux1.PIN. Nothing moves before it is on. A pin stays on when Boresight dies, so wire the brakes to close without power. Empty: no brake.</source>
        <translation>Uma saída que está ligada enquanto os travões dos eixos estão soltos: file:CAMINHO, mqtt:TÓPICO, command:PROGRAMA com os seus argumentos, dtr:PORTA, rts:PORTA ou moteus:ID:aux1.PINO. Nada se move antes de ela estar ligada. Um pino fica ligado quando o Boresight falha, por isso ligue os travões de modo a fecharem sem alimentação. Vazio: sem travão.</translation>
    </message>
    <message>
        <source>The angle of the axis at which it meets this switch. An axis that meets it elsewhere has lost steps. Empty: not compared.</source>
        <translation>O ângulo do eixo em que este encontra o fim de curso. Um eixo que o encontra noutro lugar perdeu passos. Vazio: não se compara.</translation>
    </message>
    <message>
        <source>an angle of the axis in degrees is expected, like -3.5, or nothing</source>
        <translation>espera-se um ângulo do eixo em graus, como -3.5, ou nada</translation>
    </message>
    <message>
        <source>Azimuth, lower end at</source>
        <translation>Azimute, fim inferior a</translation>
    </message>
    <message>
        <source>Azimuth, upper end at</source>
        <translation>Azimute, fim superior a</translation>
    </message>
    <message>
        <source>Elevation, lower end at</source>
        <translation>Elevação, fim inferior a</translation>
    </message>
    <message>
        <source>Elevation, upper end at</source>
        <translation>Elevação, fim superior a</translation>
    </message>
    <message>
        <source>Lost steps beyond</source>
        <translation>Passos perdidos acima de</translation>
    </message>
    <message>
        <source>An axis that meets a switch farther than this from the angle of the switch has lost steps. A rotator that reports its position seldom needs a larger value.</source>
        <translation>Um eixo que encontra um fim de curso a mais do que isto do ângulo deste perdeu passos. Um rotor que raramente indica a sua posição precisa de um valor maior.</translation>
    </message>
    <message>
        <source>Saved sensor offsets</source>
        <translation>Desvios guardados do sensor</translation>
    </message>
    <message>
        <source>The offsets that the sensor of an ESP32 relay controller reported when they were saved (Mount &gt; Console, Save offsets). Boresight compares them at each connection. It cannot write them to the box. Empty: not compared.</source>
        <translation>Os desvios que o sensor de um controlador de relés ESP32 indicou quando foram guardados (Montagem &gt; Consola, Guardar desvios). O Boresight compara-os em cada ligação. Não os pode escrever na caixa. Vazio: não se comparam.</translation>
    </message>
    <message>
        <source>offsets are expected like &quot;%1&quot;</source>
        <translation>esperam-se desvios como &quot;%1&quot;</translation>
    </message>
    <message>
        <source>The home run is under way.</source>
        <translation>A procura da referência está em curso.</translation>
    </message>
    <message>
        <source>no standstill within %1 min</source>
        <translation>sem paragem em %1 min</translation>
    </message>
    <message>
        <source>The sensor of the rotator has other offsets than those saved</source>
        <translation>O sensor do rotor tem desvios diferentes dos guardados</translation>
    </message>
    <message>
        <source>Boresight cannot write them to the box, and uses its angles unchanged</source>
        <translation>O Boresight não os pode escrever na caixa, e usa os ângulos dela sem os alterar</translation>
    </message>
    <message>
        <source>Point at a known direction. If the antenna misses it, find north again. Then press Save offsets on the page Console, which shows both.</source>
        <translation>Aponte para uma direção conhecida. Se a antena falhar, encontre o norte de novo. Depois prima Guardar desvios na página Consola, que mostra ambos.</translation>
    </message>
    <message>
        <source>Press Re-arm. Then make a home run, or set the position at the box. If this repeats, look for a blocked axis.</source>
        <translation>Prima Rearmar. Depois procure a referência, ou acerte a posição na caixa. Se isto se repetir, procure um eixo bloqueado.</translation>
    </message>
    <message>
        <source>Free the axis. Reduce speed and acceleration, or correct the gains. Then re-arm</source>
        <translation>Solte o eixo. Reduza a velocidade e a aceleração, ou corrija os ganhos. Depois rearme</translation>
    </message>
    <message>
        <source>Largest jerk: how fast the acceleration may change. It makes every stop longer by 2 × acceleration / jerk seconds.</source>
        <translation>Maior solavanco (jerk): a rapidez com que a aceleração pode mudar. Torna cada paragem mais longa em 2 × aceleração / jerk segundos.</translation>
    </message>
    <message>
        <source>Connect asks rotctld for the limits and for the position. Nothing moves. For some models rotctld sends a greeting to the box.</source>
        <translation>Conectar pergunta ao rotctld os limites e a posição. Nada se move. Em alguns modelos o rotctld envia uma saudação à caixa.</translation>
    </message>
    <message>
        <source>Nobody has confirmed the directions of the axes. Boresight moves the mount at most 2° at 5°/s, and only by a jog or by the command M of a client. Check that each axis turns in the direction of the profile. Then confirm the directions in the guide of the window, or run boresightctl confirm-directions PROFILE and start again.</source>
        <translation>Ninguém confirmou os sentidos dos eixos. O Boresight move a montagem no máximo 2° a 5°/s, e só por movimento manual ou pelo comando M de um cliente. Verifique se cada eixo gira no sentido do perfil. Depois confirme os sentidos no guia da janela, ou execute boresightctl confirm-directions PERFIL e inicie de novo.</translation>
    </message>
    <message>
        <source>Boresight waits, because the motor may start only %3 times a minute</source>
        <translation>O Boresight espera, porque o motor só pode arrancar %3 vezes por minuto</translation>
    </message>
    <message>
        <source>Boresight does not move this axis. The other axes go on</source>
        <translation>O Boresight não move este eixo. Os outros eixos continuam</translation>
    </message>
    <message>
        <source>Wait until the wind has stayed below %2 m/s for %3 min. If the mount must move, press Move anyway</source>
        <translation>Espere até o vento ficar abaixo de %2 m/s durante %3 min. Se a montagem tiver de se mover, prima Mover mesmo assim</translation>
    </message>
    <message>
        <source>Open guide</source>
        <translation>Abrir guia</translation>
    </message>
    <message>
        <source>The drive switched its output off. An axis without a fault holds if its drive can</source>
        <translation>O acionamento desligou a sua saída. Um eixo sem falha segura, se o seu acionamento puder</translation>
    </message>
    <message>
        <source>Boresight sends no more motion commands. An axis without a fault holds if its drive can</source>
        <translation>O Boresight não envia mais comandos de movimento. Um eixo sem falha mantém-se se o seu acionamento puder</translation>
    </message>
    <message>
        <source>The position of the %1 is unknown</source>
        <translation>A posição do %1 é desconhecida</translation>
    </message>
    <message>
        <source>Look at the mount. Then enter the position of the axis</source>
        <translation>Olhe para a montagem. Depois indique a posição do eixo</translation>
    </message>
    <message>
        <source>The calm time needs readings. Without them the wind counts as strong, and a parked mount stays parked</source>
        <translation>O tempo de calma precisa de leituras. Sem elas o vento conta como forte, e uma montagem estacionada fica estacionada</translation>
    </message>
    <message>
        <source>Check the anemometer and its program, and wind.source on the page Profile</source>
        <translation>Verifique o anemómetro e o seu programa, e wind.source na página Perfil</translation>
    </message>
    <message>
        <source>The target is outside the limits (%1)</source>
        <translation>O alvo está fora dos limites (%1)</translation>
    </message>
    <message>
        <source>The mount goes to the nearest permitted point</source>
        <translation>A montagem vai para o ponto permitido mais próximo</translation>
    </message>
    <message>
        <source>Boresight will hold there until the mount can reach the target again, as the operator chose</source>
        <translation>O Boresight vai parar aí até a montagem poder alcançar de novo o alvo, como o operador escolheu</translation>
    </message>
    <message>
        <source>Press Unwrap now to reach the target on another wrap. Then hand control back to the clients</source>
        <translation>Prima Desenrolar já para alcançar o alvo noutra volta do cabo. Depois devolva o controlo aos clientes</translation>
    </message>
    <message>
        <source>The azimuth is at its cable end (%1)</source>
        <translation>O azimute está no fim do cabo (%1)</translation>
    </message>
    <message>
        <source>Boresight holds there until the mount can reach the target again, as the operator chose</source>
        <translation>O Boresight mantém a montagem aí até ela poder alcançar de novo o alvo, como o operador escolheu</translation>
    </message>
    <message>
        <source>is at its cable end (%1)</source>
        <translation>está no fim do cabo (%1)</translation>
    </message>
    <message>
        <source>The position of the %1 is unknown. Enter the position of the axis. Only slow jog works.</source>
        <translation>A posição do %1 é desconhecida. Introduza a posição do eixo. Só o jog lento funciona.</translation>
    </message>
    <message>
        <source>Hold at end is chosen already.</source>
        <translation>Parar no fim já está escolhido.</translation>
    </message>
    <message>
        <source>Bus address</source>
        <translation>Endereço CAN</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Limite inferior</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Limite superior</translation>
    </message>
    <message>
        <source>Watchdog time</source>
        <translation>Tempo do watchdog</translation>
    </message>
    <message>
        <source>Torque after watchdog</source>
        <translation>Torque após watchdog</translation>
    </message>
    <message>
        <source>Braking margin</source>
        <translation>Margem de freio</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Axis encoder</source>
        <translation>Encoder do eixo</translation>
    </message>
    <message>
        <source>Max. current</source>
        <translation>Corrente máx.</translation>
    </message>
    <message>
        <source>Max. power</source>
        <translation>Potência máx.</translation>
    </message>
    <message>
        <source>Max. supply</source>
        <translation>Tensão máx.</translation>
    </message>
    <message>
        <source>Max. speed</source>
        <translation>Velocidade máx.</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Lim. velocidade</translation>
    </message>
    <message>
        <source>Accel. limit</source>
        <translation>Lim. aceleração</translation>
    </message>
    <message>
        <source>Max. error</source>
        <translation>Erro máximo</translation>
    </message>
    <message>
        <source>Max. slip</source>
        <translation>Desliz. máximo</translation>
    </message>
    <message>
        <source>unwraps the cable by %1 because the cable ends at axis %2. The target is lost for about %3</source>
        <translation>desenrola o cabo %1 porque o cabo acaba em %2 do eixo. O alvo perde-se durante cerca de %3</translation>
    </message>
    <message>
        <source>unwraps the cable by %1</source>
        <translation>desenrola o cabo %1</translation>
    </message>
    <message>
        <source>the start at %1</source>
        <translation>o arranque às %1</translation>
    </message>
    <message>
        <source>the change of the profile at %1</source>
        <translation>a alteração do perfil às %1</translation>
    </message>
    <message>
        <source>%1 Hand over when the wind has stayed below %2 m/s for %3 min.</source>
        <translation>%1 Entregue quando o vento tiver ficado abaixo de %2 m/s durante %3 min.</translation>
    </message>
    <message>
        <source>Permitted: azimuth axis %1, elevation %2.</source>
        <translation>Permitido: eixo de azimute %1, elevação %2.</translation>
    </message>
    <message>
        <source>What the mount does after a pass while the schedule is armed. &quot;unwind&quot; unwraps the cable.</source>
        <translation>O que a montagem faz depois de uma passagem enquanto a agenda está armada. &quot;unwind&quot; desenrola o cabo.</translation>
    </message>
    <message>
        <source>%1 does not move: it moved %2 in %3 instead of %4</source>
        <translation>%1 não se move: moveu-se %2 em %3 em vez de %4</translation>
    </message>
    <message>
        <source>Moves the %1 up to ±%2 around axis angle %3 and back, in %4 s.</source>
        <translation>Move o %1 até ±%2 em torno do ângulo do eixo %3 e de volta, em %4 s.</translation>
    </message>
    <message>
        <source>Moves the %1 by %2 from axis angle %3 and back, in %4 s.</source>
        <translation>Move o %1 %2 a partir do ângulo do eixo %3 e volta, em %4 s.</translation>
    </message>
    <message>
        <source>Look for what blocks the axis, such as a cable that is wrapped around the mount. Jog the other way.</source>
        <translation>Procure o que bloqueia o eixo, por exemplo um cabo enrolado à volta da montagem. Mova para o outro lado.</translation>
    </message>
    <message>
        <source>The position of the axis stays unknown</source>
        <translation>A posição do eixo continua desconhecida</translation>
    </message>
    <message>
        <source>The %1 limits its torque: its board is at %2 °C</source>
        <translation>O %1 limita o torque: a placa está a %2 °C</translation>
    </message>
    <message>
        <source>limit 100: its board is at %2 °C</source>
        <translation>limite 100: a placa está a %2 °C</translation>
    </message>
    <message>
        <source>The %1 limits its torque: its motor is at %2 °C</source>
        <translation>O %1 limita o torque: o motor está a %2 °C</translation>
    </message>
    <message>
        <source>limit 101: its motor is at %2 °C</source>
        <translation>limite 101: o motor está a %2 °C</translation>
    </message>
    <message>
        <source>Set rotctld.outside_limits to &quot;nearest&quot;.</source>
        <translation>Defina rotctld.outside_limits para &quot;nearest&quot;.</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>Motivo: %1</translation>
    </message>
    <message>
        <source>%1 errors in a row. Gpredict disengages after %2. %3</source>
        <translation>%1 erros seguidos. O Gpredict desengata após %2. %3</translation>
    </message>
    <message>
        <source>%1 The mount stays parked until the wind stays below %2 m/s for %3 min.</source>
        <translation>%1 A montagem fica estacionada até o vento ficar abaixo de %2 m/s durante %3 min.</translation>
    </message>
    <message>
        <source>The board was at %1 °C and is at %2 °C now</source>
        <translation>A placa estava a %1 °C e está agora a %2 °C</translation>
    </message>
    <message>
        <source>The board is at %1 °C</source>
        <translation>A placa está a %1 °C</translation>
    </message>
    <message>
        <source>The motor was at %1 °C and is at %2 °C now</source>
        <translation>O motor estava a %1 °C e está agora a %2 °C</translation>
    </message>
    <message>
        <source>The motor is at %1 °C</source>
        <translation>O motor está a %1 °C</translation>
    </message>
    <message>
        <source>moteus</source>
        <translation>moteus</translation>
    </message>
    <message>
        <source>GS-232</source>
        <translation>GS-232</translation>
    </message>
    <message>
        <source>Hamlib (rotctld)</source>
        <translation>Hamlib (rotctld)</translation>
    </message>
    <message>
        <source>Simple (simulated)</source>
        <translation>Simples (simulado)</translation>
    </message>
    <message>
        <source>No such axis</source>
        <translation>Sem este eixo</translation>
    </message>
    <message>
        <source>No command</source>
        <translation>Nenhum comando</translation>
    </message>
    <message>
        <source>Stop and read</source>
        <translation>Parar e ler</translation>
    </message>
    <message>
        <source>Move the mount</source>
        <translation>Mover a montagem</translation>
    </message>
    <message>
        <source>By kind of target</source>
        <translation>Por tipo de alvo</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Desligado</translation>
    </message>
    <message>
        <source>Optical</source>
        <translation>Ótica</translation>
    </message>
    <message>
        <source>Radio</source>
        <translation>Rádio</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhuma</translation>
    </message>
    <message>
        <source>UDP</source>
        <translation>UDP</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>Broker MQTT</translation>
    </message>
    <message>
        <source>Listen by UDP</source>
        <translation>Escutar por UDP</translation>
    </message>
    <message>
        <source>Connect by TCP</source>
        <translation>Ligar por TCP</translation>
    </message>
    <message>
        <source>Input is off</source>
        <translation>Entrada desligada</translation>
    </message>
    <message>
        <source>Input is on</source>
        <translation>Entrada ligada</translation>
    </message>
    <message>
        <source>Counts as pressed</source>
        <translation>Conta como premido</translation>
    </message>
    <message>
        <source>Alarm only</source>
        <translation>Só alarme</translation>
    </message>
    <message>
        <source>Azimuth/elevation</source>
        <translation>Azimute/elevação</translation>
    </message>
    <message>
        <source>X/Y</source>
        <translation>X/Y</translation>
    </message>
    <message>
        <source>Only if synchronised</source>
        <translation>Só se sincronizado</translation>
    </message>
    <message>
        <source>Always trusted</source>
        <translation>Sempre de confiança</translation>
    </message>
    <message>
        <source>The more important</source>
        <translation>A mais importante</translation>
    </message>
    <message>
        <source>The longer</source>
        <translation>A mais longa</translation>
    </message>
    <message>
        <source>The earlier</source>
        <translation>A primeira</translation>
    </message>
    <message>
        <source>Hold position</source>
        <translation>Manter a posição</translation>
    </message>
    <message>
        <source>Unwrap the cable</source>
        <translation>Desenrolar o cabo</translation>
    </message>
    <message>
        <source>Park</source>
        <translation>Estacionar</translation>
    </message>
    <message>
        <source>Simulated sensor</source>
        <translation>Sensor simulado</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Sentido horário</translation>
    </message>
    <message>
        <source>Counterclockwise</source>
        <translation>Sentido anti-horário</translation>
    </message>
    <message>
        <source>Same as the beam</source>
        <translation>Igual ao feixe</translation>
    </message>
    <message>
        <source>Opposite to the beam</source>
        <translation>Contrária ao feixe</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Boresight</source>
        <translation>Boresight</translation>
    </message>
    <message>
        <source>Nowhere</source>
        <translation>Em lado nenhum</translation>
    </message>
    <message>
        <source>Confirmed</source>
        <translation>Confirmados</translation>
    </message>
    <message>
        <source>Not confirmed</source>
        <translation>Não confirmados</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Acionamento</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>Este computador</translation>
    </message>
    <message>
        <source>Brake</source>
        <translation>Travão</translation>
    </message>
    <message>
        <source>Separately</source>
        <translation>Em separado</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Ao mesmo tempo</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Retomar</translation>
    </message>
    <message>
        <source>Wait for re-arm</source>
        <translation>Esperar por rearme</translation>
    </message>
    <message>
        <source>Torque off</source>
        <translation>Torque desligado</translation>
    </message>
    <message>
        <source>First client</source>
        <translation>Primeiro cliente</translation>
    </message>
    <message>
        <source>Latest client</source>
        <translation>Último cliente</translation>
    </message>
    <message>
        <source>One client only</source>
        <translation>Só um cliente</translation>
    </message>
    <message>
        <source>Nearest point</source>
        <translation>Ponto mais próximo</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Recusar</translation>
    </message>
    <message>
        <source>0…360°</source>
        <translation>0…360°</translation>
    </message>
    <message>
        <source>-180…180°</source>
        <translation>-180…180°</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Contínuo</translation>
    </message>
    <message>
        <source>Old and new Hamlib</source>
        <translation>Hamlib antigo e novo</translation>
    </message>
    <message>
        <source>As Hamlib 4.5.1</source>
        <translation>Como o Hamlib 4.5.1</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ligado</translation>
    </message>
    <message>
        <source>Ambiguous</source>
        <translation>Ambígua</translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation>De confiança</translation>
    </message>
    <message>
        <source>While the cable wrap of an axis is unknown, or may have been entered wrongly, stop the mount at this share of the largest torque. A cable may pull.</source>
        <translation>Enquanto a volta do cabo de um eixo for desconhecida, ou puder ter sido mal indicada, parar a montagem a esta parte do torque máximo. Um cabo pode estar a puxar.</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nunca</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Uma vez</translation>
    </message>
    <message>
        <source>At intervals</source>
        <translation>A intervalos</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>km/h</source>
        <translation>km/h</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Nós</translation>
    </message>
    <message>
        <source>Raise an alarm</source>
        <translation>Dar um alarme</translation>
    </message>
    <message>
        <source>Park the mount</source>
        <translation>Estacionar a montagem</translation>
    </message>
    <message>
        <source>Park position</source>
        <translation>Posição de estacionamento</translation>
    </message>
    <message>
        <source>The place below</source>
        <translation>O lugar abaixo</translation>
    </message>
    <message>
        <source>its computer or its program did not respond for 10 s</source>
        <translation>o seu computador ou o seu programa não respondeu durante 10 s</translation>
    </message>
    <message>
        <source>%1 needs %2 Nm, %3 % of the %4 Nm allowed. Its entered cable wrap may be wrong</source>
        <translation>%1 precisa de %2 Nm, %3 % dos %4 Nm permitidos. A volta do cabo indicada pode estar errada</translation>
    </message>
    <message>
        <source>%1 needs %2 Nm, %3 % of the %4 Nm allowed. Its position is unknown</source>
        <translation>%1 precisa de %2 Nm, %3 % dos %4 Nm permitidos. A sua posição é desconhecida</translation>
    </message>
    <message>
        <source>Boresight no longer tracks %1 from its own orbit: %2</source>
        <translation>O Boresight já não segue %1 pela sua própria órbita: %2</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Sempre</translation>
    </message>
    <message>
        <source>Ask</source>
        <translation>Perguntar</translation>
    </message>
    <message>
        <source>Lock to the target of a client</source>
        <translation>Fixar no alvo de um cliente</translation>
    </message>
    <message>
        <source>the client stopped the mount</source>
        <translation>o cliente parou a montagem</translation>
    </message>
    <message>
        <source>Boresight offers no target of this client any more.</source>
        <translation>O Boresight já não propõe nenhum alvo deste cliente.</translation>
    </message>
    <message>
        <source>tracks %1. Boresight tracks it from its own orbit from now on</source>
        <translation>segue %1. A partir de agora o Boresight segue-o pela sua própria órbita</translation>
    </message>
    <message>
        <source>the client was silent for %1 s</source>
        <translation>o cliente esteve %1 s em silêncio</translation>
    </message>
    <message>
        <source>the client parked the mount</source>
        <translation>o cliente estacionou a montagem</translation>
    </message>
    <message>
        <source>points more than %1° away from %2</source>
        <translation>aponta a mais de %1° de %2</translation>
    </message>
    <message>
        <source>the points of the client are more than %1° away from it</source>
        <translation>os pontos do cliente estão a mais de %1° dele</translation>
    </message>
    <message>
        <source>The points fit several targets alike: %1. The points move the mount</source>
        <translation>Os pontos servem igualmente a vários alvos: %1. Os pontos movem a montagem</translation>
    </message>
    <message>
        <source>%1 is at the same place as %2</source>
        <translation>%1 está no mesmo lugar que %2</translation>
    </message>
    <message>
        <source>tracks %1. Boresight can track it from its own orbit: press Track it in the window, or set clients.lock to &quot;always&quot;</source>
        <translation>segue %1. O Boresight pode segui-lo pela sua própria órbita: prima Segui-lo na janela, ou ponha clients.lock em &quot;always&quot;</translation>
    </message>
    <message>
        <source>tracks %1, but Boresight cannot track it from its own orbit: %2</source>
        <translation>segue %1, mas o Boresight não o pode seguir pela sua própria órbita: %2</translation>
    </message>
    <message>
        <source>the client has disconnected</source>
        <translation>o cliente desligou-se</translation>
    </message>
    <message>
        <source>The cable has no room for the whole pass of %1</source>
        <translation>O cabo não tem folga para toda a passagem de %1</translation>
    </message>
    <message>
        <source>%2 The target is lost for %3</source>
        <translation>%2 O alvo perde-se durante %3</translation>
    </message>
    <message>
        <source>On the page Passes, the view Plan shows the other ways</source>
        <translation>Na página Passagens, a vista Plano mostra os outros caminhos</translation>
    </message>
    <message>
        <source>It is off by more than half of the beam width for %1</source>
        <translation>O desvio passa de metade da largura do feixe durante %1</translation>
    </message>
    <message>
        <source>Direct</source>
        <translation>Direto</translation>
    </message>
    <message>
        <source>Over the top</source>
        <translation>Pelo outro lado do zénite</translation>
    </message>
    <message>
        <source>Through the zenith</source>
        <translation>Através do zénite</translation>
    </message>
    <message>
        <source>Other way round</source>
        <translation>Pelo sentido contrário</translation>
    </message>
    <message>
        <source>Waits at the cable end</source>
        <translation>Espera no fim do cabo</translation>
    </message>
    <message>
        <source>Unwraps in the pass</source>
        <translation>Desenrola na passagem</translation>
    </message>
    <message>
        <source>%1 (−%2 dB)</source>
        <translation>%1 (−%2 dB)</translation>
    </message>
    <message>
        <source>%1 (beyond the beam)</source>
        <translation>%1 (fora do feixe)</translation>
    </message>
    <message>
        <source>The mount unwraps from %1 to %2.</source>
        <translation>A montagem desenrola de %1 a %2.</translation>
    </message>
    <message>
        <source>The mount waits at the end of the cable while the target is beyond it.</source>
        <translation>A montagem espera no fim do cabo enquanto o alvo está além dele.</translation>
    </message>
    <message>
        <source>plans the pass of %1 over the top: off by up to %2</source>
        <translation>planeia a passagem de %1 pelo outro lado do zénite: desvio até %2</translation>
    </message>
    <message>
        <source>plans the pass of %1 through the zenith, and changes over the top there: off by up to %2</source>
        <translation>planeia a passagem de %1 através do zénite, onde muda para o outro lado: desvio até %2</translation>
    </message>
    <message>
        <source>plans the pass of %1 with the azimuth going the other way round near the zenith: off by up to %2</source>
        <translation>planeia a passagem de %1 com o azimute a rodar no sentido contrário perto do zénite: desvio até %2</translation>
    </message>
    <message>
        <source>What Boresight does when it recognises the target that a client tracks, such as a satellite of Gpredict. &quot;always&quot;: it tracks the target from its own orbit as soon as the points of the client move along the target. &quot;ask&quot;: the window offers this. &quot;never&quot;: only the points of the client move the mount. While rotctld.outside_limits is &quot;refuse&quot;, &quot;always&quot; and &quot;ask&quot; do the same as &quot;never&quot;.</source>
        <translation>O que o Boresight faz quando reconhece o alvo que um cliente segue, como um satélite do Gpredict. &quot;always&quot;: segue o alvo pela sua própria órbita assim que os pontos do cliente avançam com o alvo. &quot;ask&quot;: a janela propõe-no. &quot;never&quot;: só os pontos do cliente movem a montagem. Enquanto rotctld.outside_limits for &quot;refuse&quot;, &quot;always&quot; e &quot;ask&quot; fazem o mesmo que &quot;never&quot;.</translation>
    </message>
    <message>
        <source>the setting clients.lock is &quot;never&quot;</source>
        <translation>a definição clients.lock é &quot;never&quot;</translation>
    </message>
    <message>
        <source>the setting rotctld.outside_limits is &quot;refuse&quot;</source>
        <translation>a definição rotctld.outside_limits é &quot;refuse&quot;</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 e mais %2</translation>
    </message>
    <message>
        <source>The client tracks another target now: %1.</source>
        <translation>O cliente segue agora outro alvo: %1.</translation>
    </message>
    <message>
        <source>The client has not read the position in the last %1 s. Boresight tracks a target only for a client that reads the position.</source>
        <translation>O cliente não leu a posição nos últimos %1 s. O Boresight só segue um alvo para um cliente que lê a posição.</translation>
    </message>
    <message>
        <source>The mount holds</source>
        <translation>A montagem mantém a posição</translation>
    </message>
    <message>
        <source>Nothing to do if the client has ended. Otherwise the next point of the client moves the mount</source>
        <translation>Nada a fazer se o cliente terminou. Caso contrário, o próximo ponto do cliente move a montagem</translation>
    </message>
    <message>
        <source>another client moves the mount</source>
        <translation>outro cliente move a montagem</translation>
    </message>
    <message>
        <source>The commands of the other client move the mount</source>
        <translation>Os comandos do outro cliente movem a montagem</translation>
    </message>
    <message>
        <source>The page Clients shows which client has control</source>
        <translation>A página Clientes mostra que cliente tem o controlo</translation>
    </message>
    <message>
        <source>Nothing to do if this is intended. Otherwise press Hold</source>
        <translation>Nada a fazer se isto for intencional. Caso contrário, prima Manter</translation>
    </message>
    <message>
        <source>The mount moves to its park position</source>
        <translation>A montagem move-se para a posição de estacionamento</translation>
    </message>
    <message>
        <source>The points of the client move the mount</source>
        <translation>Os pontos do cliente movem a montagem</translation>
    </message>
    <message>
        <source>the client sent a move command</source>
        <translation>o cliente enviou um comando de movimento</translation>
    </message>
    <message>
        <source>The move command of the client moves the mount</source>
        <translation>O comando de movimento do cliente move a montagem</translation>
    </message>
    <message>
        <source>Nothing to do if the client has another target</source>
        <translation>Nada a fazer se o cliente tem outro alvo</translation>
    </message>
    <message>
        <source>waits for the rise of %1. Boresight tracks it from its own orbit when the points move along it, or when you press Track it in the window</source>
        <translation>espera que %1 nasça. O Boresight segue-o pela sua própria órbita quando os pontos avançam com ele, ou quando prime Segui-lo na janela</translation>
    </message>
    <message>
        <source>cannot take the way that was chosen any more: %1. It takes the best</source>
        <translation>já não pode seguir o caminho escolhido: %1. Segue o melhor</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Way to the target</source>
        <translation>Até ao alvo</translation>
    </message>
    <message>
        <source>Between points</source>
        <translation>Entre pontos</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Relógio</translation>
    </message>
    <message>
        <source>Age of elements</source>
        <translation>Idade dos elementos</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibração</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vento</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>pelo menos %1</translation>
    </message>
    <message>
        <source>Off by %1 (%2)</source>
        <translation>Desvio de %1 (%2)</translation>
    </message>
    <message>
        <source>beyond the main lobe</source>
        <translation>fora do lóbulo principal</translation>
    </message>
    <message>
        <source>not in the sum</source>
        <translation>não somado</translation>
    </message>
    <message>
        <source>The target moves %1/s.</source>
        <translation>O alvo move-se a %1/s.</translation>
    </message>
    <message>
        <source>The axes have not answered a set-point.</source>
        <translation>Os eixos não responderam a nenhuma referência.</translation>
    </message>
    <message>
        <source>Measured: rms of the last 10 s. Now %1. Peak %2.</source>
        <translation>Medido: rms dos últimos 10 s. Agora %1. Pico %2.</translation>
    </message>
    <message>
        <source>The steps of the rotator add %1.</source>
        <translation>Os passos do rotor acrescentam %1.</translation>
    </message>
    <message>
        <source>From the set-points to the target, now.</source>
        <translation>Das referências ao alvo, agora.</translation>
    </message>
    <message>
        <source>Boresight computes each position. Nothing lies between points.</source>
        <translation>O Boresight calcula cada posição. Não há nada entre pontos.</translation>
    </message>
    <message>
        <source>Too few points have arrived.</source>
        <translation>Chegaram poucos pontos.</translation>
    </message>
    <message>
        <source>The points are %1 apart.</source>
        <translation>Os pontos distam %1.</translation>
    </message>
    <message>
        <source>The path foretold them with this rms error.</source>
        <translation>A trajetória previu-os com este erro rms.</translation>
    </message>
    <message>
        <source>Half a step.</source>
        <translation>Metade de um passo.</translation>
    </message>
    <message>
        <source>Boresight does not know the clock of the program that sends the points.</source>
        <translation>O Boresight não conhece o relógio do programa que envia os pontos.</translation>
    </message>
    <message>
        <source>The clock of this computer was set, and Boresight points by the old time. %1</source>
        <translation>O relógio deste computador foi acertado, e o Boresight aponta pela hora antiga. %1</translation>
    </message>
    <message>
        <source>No time source sets the clock. %1</source>
        <translation>Nenhuma fonte de tempo acerta o relógio. %1</translation>
    </message>
    <message>
        <source>The time source reports no error. %1</source>
        <translation>A fonte de tempo não comunica nenhum erro. %1</translation>
    </message>
    <message>
        <source>The time source reports an error of %1 ms. %2</source>
        <translation>A fonte de tempo comunica um erro de %1 ms. %2</translation>
    </message>
    <message>
        <source>Boresight does not know the elements of the client.</source>
        <translation>O Boresight não conhece os elementos do cliente.</translation>
    </message>
    <message>
        <source>The elements of the satellite are not loaded now.</source>
        <translation>Os elementos do satélite não estão carregados agora.</translation>
    </message>
    <message>
        <source>%1 days old. Expected: %2 km along the orbit, %3 s.</source>
        <translation>Com %1 dias. Esperado: %2 km ao longo da órbita, %3 s.</translation>
    </message>
    <message>
        <source>The stated uncertainty of the calibration in force.</source>
        <translation>A incerteza indicada da calibração em vigor.</translation>
    </message>
    <message>
        <source>No point was measured, and north has no stated uncertainty.</source>
        <translation>Nenhum ponto foi medido, e o norte não tem incerteza indicada.</translation>
    </message>
    <message>
        <source>Not in the sum. Nothing measures how far the wind bends mast and antenna.</source>
        <translation>Não somado. Nada mede quanto o vento dobra o mastro e a antena.</translation>
    </message>
    <message>
        <source>Wind %1 m/s.</source>
        <translation>Vento %1 m/s.</translation>
    </message>
    <message>
        <source>No fresh wind reading.</source>
        <translation>Sem leitura recente do vento.</translation>
    </message>
    <message>
        <source>Residual rms of the measured points (%1), at least the uncertainty of their centring.</source>
        <translation>Resíduo rms dos pontos medidos (%1), pelo menos a incerteza da sua centragem.</translation>
    </message>
    <message>
        <source>Write protocol-lines with the number of the last line that you know. The first lines come after 0.</source>
        <translation>Escreva protocol-lines com o número da última linha que conhece. As primeiras linhas vêm depois de 0.</translation>
    </message>
    <message>
        <source>This is not a command. The commands are take, release, stop, reset-stop, override-wind, use-new-time, satellites, status, transmit, track TARGET, antennas, antenna NAME, simulate FAULT, console LINE, console-lines, protocol-log-on, protocol-log-off, protocol-lines NUMBER and the commands of the schedule.</source>
        <translation>Isto não é um comando. Os comandos são take, release, stop, reset-stop, override-wind, use-new-time, satellites, status, transmit, track TARGET, antennas, antenna NAME, simulate FAULT, console LINE, console-lines, protocol-log-on, protocol-log-off, protocol-lines NUMBER e os comandos da agenda.</translation>
    </message>
    <message>
        <source>go to %1 / %2</source>
        <translation>ir para %1 / %2</translation>
    </message>
    <message>
        <source>asks the position</source>
        <translation>pergunta a posição</translation>
    </message>
    <message>
        <source>asks the target</source>
        <translation>pergunta o alvo</translation>
    </message>
    <message>
        <source>asks whether the mount moves</source>
        <translation>pergunta se a montagem se move</translation>
    </message>
    <message>
        <source>move up</source>
        <translation>mover para cima</translation>
    </message>
    <message>
        <source>move down</source>
        <translation>mover para baixo</translation>
    </message>
    <message>
        <source>move left</source>
        <translation>mover para a esquerda</translation>
    </message>
    <message>
        <source>move right</source>
        <translation>mover para a direita</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>parar</translation>
    </message>
    <message>
        <source>park</source>
        <translation>estacionar</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>repor</translation>
    </message>
    <message>
        <source>set the jog speed to level %1</source>
        <translation>pôr a velocidade manual no nível %1</translation>
    </message>
    <message>
        <source>command %1</source>
        <translation>comando %1</translation>
    </message>
    <message>
        <source>not understood</source>
        <translation>não compreendido</translation>
    </message>
    <message>
        <source>not understood: %1</source>
        <translation>não compreendido: %1</translation>
    </message>
    <message>
        <source>refused. %1</source>
        <translation>recusado. %1</translation>
    </message>
    <message>
        <source>%1… (%2 bytes)</source>
        <translation>%1… (%2 bytes)</translation>
    </message>
    <message>
        <source>asks for information</source>
        <translation>pede informação</translation>
    </message>
    <message>
        <source>the protocol log begins</source>
        <translation>o registo do protocolo começa</translation>
    </message>
    <message>
        <source>the protocol log ends</source>
        <translation>o registo do protocolo termina</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>gravação</translation>
    </message>
    <message>
        <source>Record passes</source>
        <translation>Gravar passagens</translation>
    </message>
    <message>
        <source>Keep for</source>
        <translation>Conservar durante</translation>
    </message>
    <message>
        <source>Keep at most</source>
        <translation>Conservar no máximo</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>o disco não responde</translation>
    </message>
    <message>
        <source>cannot make the folder %1</source>
        <translation>não é possível criar a pasta %1</translation>
    </message>
    <message>
        <source>this is not a recording of a pass. The mark at its first 8 bytes is missing</source>
        <translation>isto não é uma gravação de uma passagem. Falta a marca nos primeiros 8 bytes</translation>
    </message>
    <message>
        <source>byte 8: the recording has version %1, but this program reads version %2. Read it with the program that wrote it</source>
        <translation>byte 8: a gravação tem a versão %1, mas este programa lê a versão %2. Leia-a com o programa que a escreveu</translation>
    </message>
    <message>
        <source>byte %1: the header of the recording is damaged or cut. Its ticks cannot be read without the header</source>
        <translation>byte %1: o cabeçalho da gravação está danificado ou cortado. Sem o cabeçalho não se podem ler os instantes</translation>
    </message>
    <message>
        <source>byte %1: the recording has no end. Its last seconds may be missing</source>
        <translation>byte %1: a gravação não tem fim. Podem faltar os últimos segundos</translation>
    </message>
    <message>
        <source>bytes %1 to %2 are damaged or cut. They are left out</source>
        <translation>os bytes %1 a %2 estão danificados ou cortados. Foram omitidos</translation>
    </message>
    <message>
        <source>cannot read: %1</source>
        <translation>não se pode ler: %1</translation>
    </message>
    <message>
        <source>%1, off by up to %2</source>
        <translation>%1, desvio até %2</translation>
    </message>
    <message>
        <source>%1, off target for %2</source>
        <translation>%1, fora do alvo durante %2</translation>
    </message>
    <message>
        <source>plans the pass of %1 near the zenith, where the azimuth is too slow: off by up to %2</source>
        <translation>planeia a passagem de %1 perto do zénite, onde o azimute é demasiado lento: desvio até %2</translation>
    </message>
    <message>
        <source>plans the pass of %1, for which the cable has no room. %2 The beam is off it for %3</source>
        <translation>planeia a passagem de %1, para a qual o cabo não tem folga. %2 O feixe fica fora dela durante %3</translation>
    </message>
    <message>
        <source>unwrap the cable for %1</source>
        <translation>desenrolar o cabo para %1</translation>
    </message>
    <message>
        <source>The recording has no ticks. It ended before the mount was measured.</source>
        <translation>A gravação não tem medições. Terminou antes de a montagem ser medida.</translation>
    </message>
    <message>
        <source>The recording has no readable ticks. %1</source>
        <translation>A gravação não tem medições legíveis. %1</translation>
    </message>
    <message>
        <source>%1 at %2, %3</source>
        <translation>%1 a %2, %3</translation>
    </message>
    <message>
        <source>direct</source>
        <translation>direto</translation>
    </message>
    <message>
        <source>over the top</source>
        <translation>pelo outro lado</translation>
    </message>
    <message>
        <source>through the zenith</source>
        <translation>pelo zénite</translation>
    </message>
    <message>
        <source>the other way round</source>
        <translation>pela volta contrária</translation>
    </message>
    <message>
        <source>waits at the cable end</source>
        <translation>espera no fim do cabo</translation>
    </message>
    <message>
        <source>unwraps the cable</source>
        <translation>desenrola o cabo</translation>
    </message>
    <message>
        <source>%1, %2 without ticks</source>
        <translation>%1, %2 sem medições</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Passagem</translation>
    </message>
    <message>
        <source>Tracked by</source>
        <translation>Seguido por</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Gravado</translation>
    </message>
    <message>
        <source>Highest point</source>
        <translation>Ponto mais alto</translation>
    </message>
    <message>
        <source>On target after</source>
        <translation>No alvo após</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source>Strongest wind</source>
        <translation>Vento mais forte</translation>
    </message>
    <message>
        <source>Pointing error</source>
        <translation>Erro de apontamento</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Pico</translation>
    </message>
    <message>
        <source>Peak at</source>
        <translation>Pico a</translation>
    </message>
    <message>
        <source>Beyond half of the beam</source>
        <translation>Além de metade do feixe</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Expected RMS</source>
        <translation>RMS esperado</translation>
    </message>
    <message>
        <source>Expected peak</source>
        <translation>Pico esperado</translation>
    </message>
    <message>
        <source>Expected beyond</source>
        <translation>Além, esperado</translation>
    </message>
    <message>
        <source>Hidden by the limits</source>
        <translation>Oculto pelos limites</translation>
    </message>
    <message>
        <source>Mean torque</source>
        <translation>Torque médio</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Velocidade máxima</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Gravação</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Medições</translation>
    </message>
    <message>
        <source>Lost ticks</source>
        <translation>Medições perdidas</translation>
    </message>
    <message>
        <source>unknown target</source>
        <translation>alvo desconhecido</translation>
    </message>
    <message>
        <source>unnamed mount</source>
        <translation>montagem sem nome</translation>
    </message>
    <message>
        <source>%1, simulated</source>
        <translation>%1, simulada</translation>
    </message>
    <message>
        <source>%1 to %2 UTC</source>
        <translation>%1 a %2 UTC</translation>
    </message>
    <message>
        <source>Parts of the file could not be read: %1.</source>
        <translation>Partes do ficheiro que não foi possível ler: %1.</translation>
    </message>
    <message>
        <source>The recording ended without an orderly end.</source>
        <translation>A gravação não terminou de forma ordenada.</translation>
    </message>
    <message>
        <source>%1: the name of a report ends with .pdf or .png</source>
        <translation>%1: o nome de um relatório termina em .pdf ou .png</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>Não é possível escrever %1: %2</translation>
    </message>
    <message>
        <source>Two passes compared</source>
        <translation>Comparação de duas passagens</translation>
    </message>
    <message>
        <source>Report of a pass</source>
        <translation>Relatório de uma passagem</translation>
    </message>
    <message>
        <source>%1, station %2</source>
        <translation>%1, estação %2</translation>
    </message>
    <message>
        <source>%1: not recorded</source>
        <translation>%1: não gravado</translation>
    </message>
    <message>
        <source>Pointing error (°)</source>
        <translation>Erro de apontamento (°)</translation>
    </message>
    <message>
        <source>Azimuth torque (Nm)</source>
        <translation>Torque do azimute (Nm)</translation>
    </message>
    <message>
        <source>Elevation torque (Nm)</source>
        <translation>Torque da elevação (Nm)</translation>
    </message>
    <message>
        <source>ALARM</source>
        <translation>ALARME</translation>
    </message>
    <message>
        <source>WARNING</source>
        <translation>AVISO</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>movimento</translation>
    </message>
    <message>
        <source>Events: none</source>
        <translation>Eventos: nenhum</translation>
    </message>
    <message>
        <source>Events. The recording has further ones: %1</source>
        <translation>Eventos. A gravação tem mais: %1</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>A report is of one recording or of two.</source>
        <translation>Um relatório é de uma gravação ou de duas.</translation>
    </message>
    <message>
        <source>Half of the beam: %1</source>
        <translation>Metade do feixe: %1</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>W</source>
        <translation>O</translation>
    </message>
    <message>
        <source>target</source>
        <translation>alvo</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>feixe</translation>
    </message>
    <message>
        <source>beam A</source>
        <translation>feixe A</translation>
    </message>
    <message>
        <source>beam B</source>
        <translation>feixe B</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>95 % of the time</source>
        <translation>95 % do tempo</translation>
    </message>
    <message>
        <source>Azimuth off the plan</source>
        <translation>Azimute fora do plano</translation>
    </message>
    <message>
        <source>Elevation off the plan</source>
        <translation>Elevação fora do plano</translation>
    </message>
    <message>
        <source>Alarms / warnings</source>
        <translation>Alarmes / avisos</translation>
    </message>
    <message>
        <source>Motions begun</source>
        <translation>Movimentos iniciados</translation>
    </message>
    <message>
        <source>The error is the angle between the beam and the target. It counts after the first second on target. On target is within half of the beam width. The parts that the limits hide by the plan do not count. The circle marks the beginning. A torque has its mean as a dark line, and its least and largest values as a light band.</source>
        <translation>O erro é o ângulo entre o feixe e o alvo. Conta depois do primeiro segundo no alvo. No alvo é dentro de metade da largura do feixe. As partes que os limites ocultam segundo o plano não contam. O círculo marca o início. O torque tem a média como linha escura, e os valores mínimo e máximo como faixa clara.</translation>
    </message>
    <message>
        <source>With &quot;on&quot; Boresight records each pass in a file: all values of both axes in each control tick, the events and the plan. At 50 Hz an hour takes at most 8 MB.</source>
        <translation>Com &quot;on&quot; o Boresight grava cada passagem num ficheiro: todos os valores dos dois eixos em cada ciclo de controlo, os eventos e o plano. A 50 Hz, uma hora ocupa no máximo 8 MB.</translation>
    </message>
    <message>
        <source>Older recordings are deleted when the next recording begins, while a time source sets the clock.</source>
        <translation>As gravações mais antigas são apagadas quando a próxima gravação começa, enquanto uma fonte de tempo acerta o relógio.</translation>
    </message>
    <message>
        <source>When a recording begins, and when the disk is full, the oldest recordings of this mount are deleted while all together are larger.</source>
        <translation>Quando uma gravação começa, e quando o disco está cheio, as gravações mais antigas desta montagem são apagadas enquanto todas juntas forem maiores.</translation>
    </message>
    <message>
        <source>byte %1: the content of block &quot;%2&quot; is not readable or too much. It is left out</source>
        <translation>byte %1: o conteúdo do bloco &quot;%2&quot; é ilegível ou demasiado. É omitido</translation>
    </message>
    <message>
        <source>further damage is not listed</source>
        <translation>os danos seguintes não são listados</translation>
    </message>
    <message>
        <source>The recording is not stored: %1</source>
        <translation>A gravação não fica guardada: %1</translation>
    </message>
    <message>
        <source>Tracking continues. Up to 30,000 ticks wait in memory</source>
        <translation>O seguimento continua. Até 30 000 ciclos esperam em memória</translation>
    </message>
    <message>
        <source>Check the disk and its free space, or reduce record.keep_megabytes</source>
        <translation>Verifique o disco e o seu espaço livre, ou reduza record.keep_megabytes</translation>
    </message>
</context>
<context>
    <name>Theme</name>
    <message>
        <source>Night</source>
        <translation>Noite</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Vermelho</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Dia</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Médio</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Baixo</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Alto</translation>
    </message>
</context>
<context>
    <name>TuningWords</name>
    <message>
        <source>Error rms</source>
        <translation>Erro rms</translation>
    </message>
    <message>
        <source>Error peak</source>
        <translation>Erro máximo</translation>
    </message>
    <message>
        <source>Torque rms</source>
        <translation>Torque rms</translation>
    </message>
    <message>
        <source>Torque peak</source>
        <translation>Torque máximo</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Ultrapassagem</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Tempo até estabilizar</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>Atraso</translation>
    </message>
    <message>
        <source>Error at start</source>
        <translation>Erro no arranque</translation>
    </message>
    <message>
        <source>At %1 Hz</source>
        <translation>A %1 Hz</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Folga</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incerteza</translation>
    </message>
    <message>
        <source>Torque in the gap</source>
        <translation>Torque na folga</translation>
    </message>
    <message>
        <source>Torque with the load</source>
        <translation>Torque com a carga</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Inversões</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Degrau</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Swings</source>
        <translation>Oscilações</translation>
    </message>
    <message>
        <source>Stiffness kp</source>
        <translation>Rigidez kp</translation>
    </message>
    <message>
        <source>Integral ki</source>
        <translation>Integral ki</translation>
    </message>
    <message>
        <source>Damping kd</source>
        <translation>Amortecimento kd</translation>
    </message>
    <message>
        <source>Limit of the integral</source>
        <translation>Limite do integral</translation>
    </message>
    <message>
        <source>Inertia feed-forward</source>
        <translation>Antecipação da inércia</translation>
    </message>
    <message>
        <source>Encoder filter</source>
        <translation>Filtro do codificador</translation>
    </message>
    <message>
        <source>First tuning, 1 of 5: read the gains of the drive.</source>
        <translation>Primeira afinação, 1 de 5: ler os ganhos do acionamento.</translation>
    </message>
    <message>
        <source>First tuning, %1 of 5: measure the run &quot;%2&quot;.</source>
        <translation>Primeira afinação, %1 de 5: medir &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>First tuning, 5 of 5: the %1 is well tuned. Nothing needs to be changed.</source>
        <translation>Primeira afinação, 5 de 5: o %1 está bem afinado. Não é preciso mudar nada.</translation>
    </message>
    <message>
        <source>First tuning, 5 of 5: change a gain as &quot;%1&quot; advises, and measure again.</source>
        <translation>Primeira afinação, 5 de 5: mude um ganho como &quot;%1&quot; aconselha e meça de novo.</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>Erro final</translation>
    </message>
</context>
<context>
    <name>VariantWords</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, %2 off by more than %3.</source>
        <translation>%1, %2 com mais de %3 de desvio.</translation>
    </message>
    <message>
        <source>The limits hide the satellite for %1.</source>
        <translation>Os limites escondem o satélite durante %1.</translation>
    </message>
    <message>
        <source>The mount follows the whole pass directly, off by up to %1.</source>
        <translation>A montagem segue toda a passagem diretamente, com desvio até %1.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>The azimuth goes from %1 to %2. The cable ends at %3 and %4.</source>
        <translation>O azimute vai de %1 a %2. O cabo acaba em %3 e %4.</translation>
    </message>
    <message>
        <source>The azimuth leaves the satellite from %1 to %2.</source>
        <translation>O azimute deixa o satélite de %1 a %2.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AboutPage</name>
    <message>
        <source>About Boresight</source>
        <translation>Acerca do Boresight</translation>
    </message>
    <message>
        <source>Boresight %1</source>
        <translation>Boresight %1</translation>
    </message>
    <message>
        <source>The controller of an antenna mount.</source>
        <translation>O controlador de uma montagem de antena.</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Licença</translation>
    </message>
    <message>
        <source>GNU General Public License, version 3 or later. There is no warranty.</source>
        <translation>GNU General Public License, versão 3 ou posterior. Não há garantia.</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotecas</translation>
    </message>
    <message>
        <source>Qt %1, Qwt, Eigen, ERFA, libarchive, libexpected, libmosquitto, OpenSSL,
SDL 2, toml++</source>
        <translation>Qt %1, Qwt, Eigen, ERFA, libarchive, libexpected, libmosquitto, OpenSSL,
SDL 2, toml++</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AlarmCard</name>
    <message>
        <source>, cleared</source>
        <translation>, terminado</translation>
    </message>
    <message>
        <source>Worst alarm</source>
        <translation>Pior alarme</translation>
    </message>
    <message>
        <source>What was done and what to do</source>
        <translation>O que foi feito e o que fazer</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>When the alarm came</source>
        <translation>Quando veio o alarme</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Reconhecer</translation>
    </message>
    <message>
        <source>Acknowledge all alarms (F8)</source>
        <translation>Reconhecer todos os alarmes (F8)</translation>
    </message>
    <message>
        <source>All alarms</source>
        <translation>Todos os alarmes</translation>
    </message>
    <message>
        <source>Open the list of alarms</source>
        <translation>Abrir a lista de alarmes</translation>
    </message>
    <message>
        <source>Cleared: %1</source>
        <translation>Terminado: %1</translation>
    </message>
    <message>
        <source>Clear the drive fault. The mount then stands in STANDBY. Nothing moves by itself.</source>
        <translation>Limpar a falha do acionamento. A montagem fica então em STANDBY. Nada se move por si.</translation>
    </message>
    <message>
        <source>Release STOP. The mount then stands in STANDBY. Nothing moves by itself.</source>
        <translation>Libertar STOP. A montagem fica então em STANDBY. Nada se move por si.</translation>
    </message>
    <message>
        <source>1 of %1</source>
        <translation>1 de %1</translation>
    </message>
    <message>
        <source>Open the list of alarms. Not acknowledged: %1</source>
        <translation>Abrir a lista de alarmes. Por reconhecer: %1</translation>
    </message>
    <message>
        <source>Do not unwrap. The mount waits at the cable end until it can reach the target again. Clients keep control</source>
        <translation>Não desenrolar. A montagem espera no fim do cabo até poder alcançar o alvo de novo. Os clientes mantêm o controlo</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mais</translation>
    </message>
    <message>
        <source>Whole alarm</source>
        <translation>Alarme completo</translation>
    </message>
    <message>
        <source>Open the whole alarm in the log</source>
        <translation>Abrir o alarme completo no registo</translation>
    </message>
    <message>
        <source>The mount may move in the wind for the time of wind.override_min. Then the mount parks again</source>
        <translation>A montagem pode mover-se com vento durante o tempo de wind.override_min. Depois a montagem volta a estacionar</translation>
    </message>
    <message>
        <source>Unwrapping loses the target for %1.</source>
        <translation>Desenrolar perde o alvo durante %1.</translation>
    </message>
    <message>
        <source>Holding at the end loses the target for %1.</source>
        <translation>Ficar no fim perde o alvo durante %1.</translation>
    </message>
    <message>
        <source>Holding at the end loses the target for about %1 if it keeps its azimuth rate.</source>
        <translation>Ficar no fim perde o alvo durante cerca de %1, se mantiver a sua velocidade em azimute.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AlarmModel</name>
    <message>
        <source>active</source>
        <translation>ativo</translation>
    </message>
    <message>
        <source>over</source>
        <translation>terminado</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 até %2</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>reconhecido</translation>
    </message>
    <message>
        <source>not acknowledged</source>
        <translation>por reconhecer</translation>
    </message>
    <message>
        <source>Boresight: %1</source>
        <translation>Boresight: %1</translation>
    </message>
    <message>
        <source>To do: %1</source>
        <translation>A fazer: %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sim</translation>
    </message>
    <message>
        <source>no</source>
        <translation>não</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Ackn.</source>
        <translation>Recon.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AlarmsPage</name>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Reconhecer</translation>
    </message>
    <message>
        <source>Acknowledge the selected alarm</source>
        <translation>Reconhecer o alarme selecionado</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Reconhecer todos</translation>
    </message>
    <message>
        <source>Acknowledge all alarms (F8)</source>
        <translation>Reconhecer todos os alarmes (F8)</translation>
    </message>
    <message>
        <source>active</source>
        <translation>ativo</translation>
    </message>
    <message>
        <source>Ackn.</source>
        <translation>Recon.</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Som</translation>
    </message>
    <message>
        <source>Sound at a new alarm</source>
        <translation>Som a cada novo alarme</translation>
    </message>
    <message>
        <source>Sound once at each new alarm</source>
        <translation>Um som a cada novo alarme, uma vez</translation>
    </message>
    <message>
        <source>All alarms are acknowledged.</source>
        <translation>Todos os alarmes estão reconhecidos.</translation>
    </message>
    <message>
        <source>No alarm is selected.</source>
        <translation>Nenhum alarme está selecionado.</translation>
    </message>
    <message>
        <source>This alarm is acknowledged.</source>
        <translation>Este alarme está reconhecido.</translation>
    </message>
    <message>
        <source>This alarm is over.</source>
        <translation>Este alarme terminou.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AntennaModel</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Beam °</source>
        <translation>Feixe °</translation>
    </message>
    <message>
        <source>Across °</source>
        <translation>Lateral °</translation>
    </message>
    <message>
        <source>Up °</source>
        <translation>Acima °</translation>
    </message>
    <message>
        <source>The offsets of the other antennas are measured from the main antenna.</source>
        <translation>Os desvios das outras antenas são medidos a partir da antena principal.</translation>
    </message>
    <message>
        <source>There is already an antenna &quot;%1&quot;.</source>
        <translation>Já existe uma antena &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>Antenna %1</source>
        <translation>Antena %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AntennaPage</name>
    <message>
        <source>About the antennas</source>
        <translation>Sobre as antenas</translation>
    </message>
    <message>
        <source>Antennas</source>
        <translation>Antenas</translation>
    </message>
    <message>
        <source>Type into a cell to change it.</source>
        <translation>Escreva numa célula para a alterar.</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>Todos os parâmetros</translation>
    </message>
    <message>
        <source>Back to all settings of the mount</source>
        <translation>Voltar a todas as definições da montagem</translation>
    </message>
    <message>
        <source>Add antenna</source>
        <translation>Adicionar antena</translation>
    </message>
    <message>
        <source>Add an antenna to the mount</source>
        <translation>Adicionar uma antena à montagem</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Remove the antenna</source>
        <translation>Remover a antena</translation>
    </message>
    <message>
        <source>Remove the selected antenna (Del)</source>
        <translation>Remover a antena selecionada (Del)</translation>
    </message>
    <message>
        <source>The main antenna cannot be removed. North is found with it.</source>
        <translation>A antena principal não pode ser removida. O norte é encontrado com ela.</translation>
    </message>
    <message>
        <source>Satellites that had this antenna: %1. They now use the antenna that you choose by hand.</source>
        <translation>Satélites que tinham esta antena: %1. Usam agora a antena que escolher à mão.</translation>
    </message>
    <message>
        <source>Each antenna has a name, a beam width, and two offsets from the beam of the main antenna.</source>
        <translation>Cada antena tem um nome, uma largura de feixe e dois desvios em relação ao feixe da antena principal.</translation>
    </message>
    <message>
        <source>The mount has the main antenna and %1 more. Boresight supports no more. Remove one first.</source>
        <translation>A montagem tem a antena principal e mais %1. O Boresight não suporta mais. Remova uma primeiro.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AntennaRow</name>
    <message>
        <source>Antenna</source>
        <translation>Antena</translation>
    </message>
    <message>
        <source>Beam of the antenna</source>
        <translation>Feixe da antena</translation>
    </message>
    <message>
        <source>beam %1</source>
        <translation>feixe %1</translation>
    </message>
    <message>
        <source>The antenna in use. All directions are those of its beam.</source>
        <translation>A antena em uso. Todas as direções são as do seu feixe.</translation>
    </message>
    <message>
        <source>Antenna: %1</source>
        <translation>Antena: %1</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Edit the antennas</source>
        <translation>Editar as antenas</translation>
    </message>
    <message>
        <source>Add, name, measure and remove antennas</source>
        <translation>Adicionar, dar nome, medir e remover antenas</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AskingPanel</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>What will happen</source>
        <translation>O que vai acontecer</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Agora não: %1</translation>
    </message>
    <message>
        <source>Close the question. Nothing is done.</source>
        <translation>Fechar a pergunta. Nada é feito.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AuthorityButton</name>
    <message>
        <source>Take control</source>
        <translation>Tomar controlo</translation>
    </message>
    <message>
        <source>Let rotctld clients move the mount again</source>
        <translation>Deixar os clientes rotctld mover de novo a montagem</translation>
    </message>
    <message>
        <source>Keep control for the operator. Boresight refuses motion commands of clients</source>
        <translation>Reservar o controlo para o operador. O Boresight recusa os comandos de movimento dos clientes</translation>
    </message>
    <message>
        <source>Hand over</source>
        <translation>Entregar</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AxisCard</name>
    <message>
        <source>age %1</source>
        <translation>idade %1</translation>
    </message>
    <message>
        <source>%1 axis, %2 … %3</source>
        <translation>eixo de %1, %2 … %3</translation>
    </message>
    <message>
        <source>
mechanical angle %1</source>
        <translation>
ângulo mecânico %1</translation>
    </message>
    <message>
        <source>
rate %1</source>
        <translation>
velocidade %1</translation>
    </message>
    <message>
        <source>supply </source>
        <translation>alimentação </translation>
    </message>
    <message>
        <source>drive </source>
        <translation>acionamento </translation>
    </message>
    <message>
        <source>motor </source>
        <translation>motor </translation>
    </message>
    <message>
        <source>torque </source>
        <translation>torque </translation>
    </message>
    <message>
        <source>current </source>
        <translation>corrente </translation>
    </message>
    <message>
        <source>Actual %1</source>
        <translation>Real de %1</translation>
    </message>
    <message>
        <source>Target %1</source>
        <translation>Alvo de %1</translation>
    </message>
    <message>
        <source>Error of %1</source>
        <translation>Erro de %1</translation>
    </message>
    <message>
        <source>Rate of %1</source>
        <translation>Velocidade de %1</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>veloc.</translation>
    </message>
    <message>
        <source>State of %1</source>
        <translation>Estado de %1</translation>
    </message>
    <message>
        <source>Error bar of %1</source>
        <translation>Barra do erro de %1</translation>
    </message>
    <message>
        <source>Detail of %1</source>
        <translation>Detalhe de %1</translation>
    </message>
    <message>
        <source>AZ</source>
        <translation>AZ</translation>
    </message>
    <message>
        <source>EL</source>
        <translation>EL</translation>
    </message>
    <message>
        <source>target</source>
        <translation>alvo</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erro</translation>
    </message>
    <message>
        <source>trim %1</source>
        <translation>compensação %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eixo %1</translation>
    </message>
    <message>
        <source>WRAP?</source>
        <translation>VOLTA?</translation>
    </message>
    <message>
        <source>the cable wrap is unknown</source>
        <translation>a volta é desconhecida</translation>
    </message>
    <message>
        <source>X %1</source>
        <translation>X %1</translation>
    </message>
    <message>
        <source>Y %1</source>
        <translation>Y %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::AzelBox</name>
    <message>
        <source>no R or T</source>
        <translation>sem R nem T</translation>
    </message>
    <message>
        <source>transmits</source>
        <translation>transmite</translation>
    </message>
    <message>
        <source>receives</source>
        <translation>recebe</translation>
    </message>
    <message>
        <source>Moon by WSJT-X: %1</source>
        <translation>Lua pelo WSJT-X: %1</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>há %1</translation>
    </message>
    <message>
        <source>Not compared, because the site is not set.</source>
        <translation>Sem comparação, porque o local não está definido.</translation>
    </message>
    <message>
        <source>Agrees with the Moon of Boresight (%1).</source>
        <translation>Coincide com a Lua do Boresight (%1).</translation>
    </message>
    <message>
        <source>Differs from the Moon of Boresight by %1.</source>
        <translation>Difere da Lua do Boresight em %1.</translation>
    </message>
    <message>
        <source>Tracked.</source>
        <translation>Seguida.</translation>
    </message>
    <message>
        <source>The mount stands still while WSJT-X transmits.</source>
        <translation>A montagem está parada enquanto o WSJT-X transmite.</translation>
    </message>
    <message>
        <source>The mount waits for the file.</source>
        <translation>A montagem espera pelo ficheiro.</translation>
    </message>
    <message>
        <source>Moon below the horizon, parked.</source>
        <translation>Lua abaixo do horizonte, estacionada.</translation>
    </message>
    <message>
        <source>File of WSJT-X</source>
        <translation>Ficheiro do WSJT-X</translation>
    </message>
    <message>
        <source>Moon by WSJT-X</source>
        <translation>Lua pelo WSJT-X</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Track Moon</source>
        <translation>Seguir Lua</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Manter</translation>
    </message>
    <message>
        <source>End tracking. The mount holds</source>
        <translation>Termina o seguimento. A montagem mantém a posição</translation>
    </message>
    <message>
        <source>Hold and stop tracking the Moon of WSJT-X</source>
        <translation>Manter e deixar de seguir a Lua do WSJT-X</translation>
    </message>
    <message>
        <source>Track the Moon of WSJT-X</source>
        <translation>Seguir a Lua do WSJT-X</translation>
    </message>
    <message>
        <source>Track the Moon with the data of WSJT-X. Boresight parks the mount while the Moon is below the horizon</source>
        <translation>Seguir a Lua com os dados do WSJT-X. O Boresight estaciona a montagem enquanto a Lua está abaixo do horizonte</translation>
    </message>
    <message>
        <source>Sets at %1 without refraction.</source>
        <translation>Põe-se às %1 sem refração.</translation>
    </message>
    <message>
        <source>Rises at %1 without refraction.</source>
        <translation>Nasce às %1 sem refração.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::BeamBox</name>
    <message>
        <source>Diameter of the dish</source>
        <translation>Diâmetro da parabólica</translation>
    </message>
    <message>
        <source>Diameter of the dish in metres</source>
        <translation>Diâmetro da parabólica em metros</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequência</translation>
    </message>
    <message>
        <source>Frequency in megahertz</source>
        <translation>Frequência em megahertz</translation>
    </message>
    <message>
        <source>Gain of the antenna</source>
        <translation>Ganho da antena</translation>
    </message>
    <message>
        <source>Gain over an isotropic antenna</source>
        <translation>Ganho em relação a uma antena isotrópica</translation>
    </message>
    <message>
        <source>Use the beam width of the dish</source>
        <translation>Usar a largura de feixe da parabólica</translation>
    </message>
    <message>
        <source>Beam width 70° × wavelength / diameter</source>
        <translation>Largura de feixe 70° × comprimento de onda / diâmetro</translation>
    </message>
    <message>
        <source>Use the beam width of the gain</source>
        <translation>Usar a largura de feixe do ganho</translation>
    </message>
    <message>
        <source>Dish</source>
        <translation>Parabólica</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Ganho</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usar %1</translation>
    </message>
    <message>
        <source>For an antenna whose beam is as wide as it is high</source>
        <translation>De uma antena com um feixe tão largo como alto</translation>
    </message>
</context>
<context>
    <name>boresight::ui::BodyBox</name>
    <message>
        <source>Take point</source>
        <translation>Tomar ponto</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Manter</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Agora não: %1</translation>
    </message>
    <message>
        <source>points taken: %1</source>
        <translation>pontos tomados: %1</translation>
    </message>
    <message>
        <source>Refraction</source>
        <translation>Refração</translation>
    </message>
    <message>
        <source>Over the top</source>
        <translation>Pelo outro lado do zénite</translation>
    </message>
    <message>
        <source>Position of the body</source>
        <translation>Onde está o astro</translation>
    </message>
    <message>
        <source>Track Sun</source>
        <translation>Seguir Sol</translation>
    </message>
    <message>
        <source>The target is centred now. Store the position of the axes</source>
        <translation>O alvo está centrado agora. Guarda a posição dos eixos</translation>
    </message>
    <message>
        <source>Refraction of the air: optical for a shadow, radio for the power</source>
        <translation>Como o ar curva o que se centra: a sombra ou a potência</translation>
    </message>
    <message>
        <source>optical</source>
        <translation>como luz</translation>
    </message>
    <message>
        <source>radio</source>
        <translation>como rádio</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desligado</translation>
    </message>
    <message>
        <source>Track %1</source>
        <translation>Seguir %1</translation>
    </message>
    <message>
        <source>End tracking. The mount holds</source>
        <translation>Termina o seguimento. A montagem mantém a posição</translation>
    </message>
    <message>
        <source>Move the mount to the %1 and track it. The pad trims</source>
        <translation>Move a montagem até ao astro (%1) e segue-o. O painel de passos compensa</translation>
    </message>
    <message>
        <source>Hold and stop tracking the %1</source>
        <translation>Manter, não seguir mais (%1)</translation>
    </message>
    <message>
        <source>tracked over the top, trim az %1 el %2</source>
        <translation>seguido pelo outro lado, comp. az %1 el %2</translation>
    </message>
    <message>
        <source>tracked, trim az %1 el %2</source>
        <translation>seguido, comp. az %1 el %2</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>não é seguido</translation>
    </message>
    <message>
        <source>not tracked, beam %1 off</source>
        <translation>não é seguido, feixe a %1 dele</translation>
    </message>
    <message>
        <source>The antenna points from the other side, with the boom past the zenith. This separates north from collimation. Take 1 of 3 points this way, or 2 of 6.</source>
        <translation>A antena aponta do outro lado, com a lança para lá do zénite. Isto separa o norte da colimação. Tome assim 1 de 3 pontos, ou 2 de 6.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::BodyPage</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Eyes and feed</source>
        <translation>Olhos e alimentador</translation>
    </message>
    <message>
        <source>Step of the pad</source>
        <translation>Passo dos botões</translation>
    </message>
    <message>
        <source>Nudge pad</source>
        <translation>Botões de passo</translation>
    </message>
    <message>
        <source>Points by the Sun</source>
        <translation>Pontos pelo Sol</translation>
    </message>
    <message>
        <source>Points by the Moon</source>
        <translation>Pontos pela Lua</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marco</translation>
    </message>
    <message>
        <source>A landmark whose direction is known</source>
        <translation>Um marco de direção conhecida</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Pico</translation>
    </message>
    <message>
        <source>The peak of the received power, by a cross scan</source>
        <translation>O pico da potência recebida, por uma varredura em cruz</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>passo %1</translation>
    </message>
    <message>
        <source>Step of one press on the pad or of an arrow key</source>
        <translation>Quanto move um toque nos botões ou numa seta</translation>
    </message>
</context>
<context>
    <name>boresight::ui::BoxConsolePanel</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Send line</source>
        <translation>Enviar linha</translation>
    </message>
    <message>
        <source>Send the line to the control box as it is (Enter). The mount must stand still.</source>
        <translation>Enviar a linha à caixa de controlo tal como está (Enter). A montagem tem de estar parada.</translation>
    </message>
    <message>
        <source>Answers of the control box</source>
        <translation>Respostas da caixa de controlo</translation>
    </message>
    <message>
        <source>Line for the control box</source>
        <translation>Linha para a caixa de controlo</translation>
    </message>
    <message>
        <source>A command in the words of the control box. Lines that move the rotator are refused.</source>
        <translation>Um comando nas palavras da caixa de controlo. As linhas que movem o rotor são recusadas.</translation>
    </message>
    <message>
        <source>The rotator drives its axes to its own switches, and counts from there again.</source>
        <translation>O rotor leva os eixos aos seus próprios interruptores e volta a contar a partir daí.</translation>
    </message>
    <message>
        <source>Drive the rotator to its own switches?</source>
        <translation>Levar o rotor aos seus próprios interruptores?</translation>
    </message>
    <message>
        <source>The rotator turns both axes by itself until they meet its switches, and counts from there again. The limits, the keep-outs and the Sun are not respected meanwhile. Look at the antenna and its cable first. STOP ends the run.

Boresight takes the rotator over again when it has stood still for some seconds. Then compare the angles with the antenna.</source>
        <translation>O rotor roda ambos os eixos sozinho até encontrarem os seus interruptores, e volta a contar a partir daí. Entretanto os limites, as zonas proibidas e o Sol não são respeitados. Observe primeiro a antena e o seu cabo. STOP termina a procura.

O Boresight retoma o rotor quando este tiver estado parado alguns segundos. Depois compare os ângulos com a antena.</translation>
    </message>
    <message>
        <source>Make the home run</source>
        <translation>Procurar a referência</translation>
    </message>
    <message>
        <source>Home run …</source>
        <translation>Procurar referência …</translation>
    </message>
</context>
<context>
    <name>boresight::ui::BudgetCard</name>
    <message>
        <source>Parts of the pointing error</source>
        <translation>Partes do erro de apontamento</translation>
    </message>
    <message>
        <source>Error budget</source>
        <translation>Balanço de erros</translation>
    </message>
    <message>
        <source>Sum of the error budget</source>
        <translation>Soma do balanço de erros</translation>
    </message>
    <message>
        <source>Independent parts are added as squares. An unknown part is not in the sum.</source>
        <translation>As partes independentes somam-se em quadrado. Uma parte desconhecida não entra na soma.</translation>
    </message>
    <message>
        <source>There is no error budget: no direction is aimed at, or the position is old.</source>
        <translation>Não há balanço de erros: não há direção visada, ou a posição é antiga.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::BudgetModel</name>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erro</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Origem</translation>
    </message>
</context>
<context>
    <name>boresight::ui::BusPicture</name>
    <message>
        <source>Cabling of adapter and drives</source>
        <translation>Cablagem do adaptador e dos acionamentos</translation>
    </message>
    <message>
        <source>Adapter and boards on one cable, with 120 Ω at both ends</source>
        <translation>Adaptador e placas num só cabo, com 120 Ω nas duas pontas</translation>
    </message>
    <message>
        <source>%1. One board is disconnected</source>
        <translation>%1. Uma placa está desligada</translation>
    </message>
    <message>
        <source>id 1</source>
        <translation>id 1</translation>
    </message>
    <message>
        <source>AZ</source>
        <translation>AZ</translation>
    </message>
    <message>
        <source>EL</source>
        <translation>EL</translation>
    </message>
    <message>
        <source>this</source>
        <translation>esta</translation>
    </message>
    <message>
        <source>other</source>
        <translation>outra</translation>
    </message>
    <message>
        <source>%1. Both boards share one id</source>
        <translation>%1. As duas placas têm o mesmo id</translation>
    </message>
</context>
<context>
    <name>boresight::ui::CalibrationBar</name>
    <message>
        <source>Proposed calibration</source>
        <translation>Calibração proposta</translation>
    </message>
    <message>
        <source>What Apply changes</source>
        <translation>O que Aplicar muda</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Apply north</source>
        <translation>Aplicar norte</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Desfazer</translation>
    </message>
    <message>
        <source>Undo the calibration</source>
        <translation>Desfazer a calibração</translation>
    </message>
    <message>
        <source>Apply to sensor</source>
        <translation>Aplicar ao sensor</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Steps 1 to 3 find north</source>
        <translation>Os passos 1 a 3 acham o norte</translation>
    </message>
    <message>
        <source>Drop the proposal. Nothing changes, and the points stay</source>
        <translation>Retira a proposta. Nada muda, e os pontos ficam</translation>
    </message>
    <message>
        <source>Discard the proposal</source>
        <translation>Descartar o que se propõe</translation>
    </message>
    <message>
        <source>In force at once, and nothing moves: %1</source>
        <translation>Vale de imediato, nada se move: %1</translation>
    </message>
    <message>
        <source>Apply an unreliable result?</source>
        <translation>Aplicar um resultado que não é de confiança?</translation>
    </message>
    <message>
        <source>This result is unreliable. %1

Apply anyway changes: %2.

The mount then points by this result. The log records that you applied it anyway. Undo returns to the calibration before.</source>
        <translation>Este resultado não é de confiança. %1

&quot;Aplicar mesmo assim&quot; muda: %2.

Depois a montagem aponta por este resultado. O registo anota que o aplicou mesmo assim. Desfazer volta à calibração anterior.</translation>
    </message>
    <message>
        <source>Apply anyway</source>
        <translation>Aplicar mesmo assim</translation>
    </message>
    <message>
        <source>Return to the previous calibration. Nothing moves</source>
        <translation>Voltar à calibração anterior. Nada se move</translation>
    </message>
</context>
<context>
    <name>boresight::ui::CalibrationBars</name>
    <message>
        <source>SYS</source>
        <translation>SIS</translation>
    </message>
    <message>
        <source>GYR</source>
        <translation>GIR</translation>
    </message>
    <message>
        <source>ACC</source>
        <translation>ACE</translation>
    </message>
    <message>
        <source>MAG</source>
        <translation>MAG</translation>
    </message>
    <message>
        <source>Gyro: hold the sensor still for some seconds.</source>
        <translation>Giroscópio: mantenha o sensor imóvel durante alguns segundos.</translation>
    </message>
    <message>
        <source>Accelerometer: hold the sensor still on each of its six sides, some seconds each.</source>
        <translation>Acelerômetro: mantenha o sensor imóvel em cada um dos seus seis lados, alguns segundos em cada.</translation>
    </message>
    <message>
        <source>Calibration: system %1, gyro %2, accelerometer %3, magnetometer %4 of 3</source>
        <translation>Calibração: sistema %1, giroscópio %2, acelerómetro %3, magnetómetro %4 de 3</translation>
    </message>
    <message>
        <source>Magnetometer: move the sensor in figures of eight, away from iron and motors. On the mast, turn the mount through its range.</source>
        <translation>Magnetómetro: mova o sensor em forma de oito, longe de ferro e motores. No mastro, gire a montagem por todo o seu curso.</translation>
    </message>
    <message>
        <source>Calibration: not reported</source>
        <translation>Calibração: não informada</translation>
    </message>
    <message>
        <source>System: this value follows the other three. At 0 the heading is not referred to north.</source>
        <translation>Sistema: este valor segue os outros três. Em 0 o rumo não está referido ao norte.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::CalibrationPanel</name>
    <message>
        <source>Steps of finding north</source>
        <translation>Passos para achar o norte</translation>
    </message>
    <message>
        <source>1 Sensor</source>
        <translation>1 Sensor</translation>
    </message>
    <message>
        <source>2 Swing</source>
        <translation>2 Giro</translation>
    </message>
    <message>
        <source>3 Sun/Moon</source>
        <translation>3 Sol/Lua</translation>
    </message>
    <message>
        <source>Points of known direction: Sun, Moon, a landmark, the peak of the power</source>
        <translation>Pontos de direção conhecida: Sol, Lua, um marco, o pico da potência</translation>
    </message>
    <message>
        <source>4 Model</source>
        <translation>4 Modelo</translation>
    </message>
    <message>
        <source>The pointing model of these points, with their residuals</source>
        <translation>O modelo de apontamento destes pontos, com os resíduos</translation>
    </message>
    <message>
        <source>5 History</source>
        <translation>5 Histórico</translation>
    </message>
    <message>
        <source>What was applied before</source>
        <translation>O que já foi aplicado</translation>
    </message>
    <message>
        <source>North from the sensor while the mount stands still, to a few degrees</source>
        <translation>Norte pelo sensor com a montagem parada: a alguns graus</translation>
    </message>
    <message>
        <source>Compass swing: north, compass error of the sensor and tilt of the axis</source>
        <translation>O giro da bússola: norte, desvio do sensor e inclinação do eixo</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ClientModel</name>
    <message>
        <source>unknown</source>
        <translation>desconhecido</translation>
    </message>
    <message>
        <source>%1, %2: %3 commands a second, last %4</source>
        <translation>%1, %2: %3 comandos por segundo, o último %4</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>só leitura</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>reservado</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Endereço</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>1/s</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Último</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Controlo</translation>
    </message>
    <message>
        <source>● in control</source>
        <translation>● move</translation>
    </message>
    <message>
        <source>in control</source>
        <translation>conduz</translation>
    </message>
    <message>
        <source>▲ waiting</source>
        <translation>▲ quer mover</translation>
    </message>
    <message>
        <source>● moves the mount</source>
        <translation>● move a montagem</translation>
    </message>
    <message>
        <source>%1 k</source>
        <comment>thousand</comment>
        <translation>%1 k</translation>
    </message>
    <message>
        <source>Odd commands: %1. A command is odd if Boresight does not know it, if its numbers are invalid (such as NaN), or if this mount does not have what the command asks for. An odd command does not move the mount.</source>
        <translation>Comandos estranhos: %1. Um comando é estranho se o Boresight não o conhece, se os seus números são inválidos (como NaN) ou se esta montagem não tem o que o comando pede. Um comando estranho não move a montagem.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ClientsPanel</name>
    <message>
        <source>Who may connect</source>
        <translation>Quem pode conectar-se</translation>
    </message>
    <message>
        <source>About the selected client</source>
        <translation>Sobre o cliente selecionado</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Settings for Gpredict</source>
        <translation>Configuração para o Gpredict</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Primeiro</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Último</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Reservado</translation>
    </message>
    <message>
        <source>Give control</source>
        <translation>Dar controlo</translation>
    </message>
    <message>
        <source>The selected client moves the mount from now on</source>
        <translation>O cliente selecionado passa a mover a montagem</translation>
    </message>
    <message>
        <source>Read-only</source>
        <translation>Só leitura</translation>
    </message>
    <message>
        <source>The selected client may only read and stop</source>
        <translation>O cliente selecionado só pode ler e parar</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconectar</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Reservar</translation>
    </message>
    <message>
        <source>Only programs on the host of the selected client move the mount</source>
        <translation>Só programas no computador do cliente selecionado movem a montagem</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Clientes</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the settings for Gpredict</source>
        <translation>Copiar a configuração para o Gpredict</translation>
    </message>
    <message>
        <source>Locked to
%1</source>
        <translation>Reservado a
%1</translation>
    </message>
    <message>
        <source>May connect to %1: %2</source>
        <translation>Podem conectar-se a %1: %2</translation>
    </message>
    <message>
        <source>Any program on this computer may connect (%1)</source>
        <translation>Qualquer programa deste computador pode conectar-se (%1)</translation>
    </message>
    <message>
        <source>May move</source>
        <translation>Deixar mover</translation>
    </message>
    <message>
        <source>The selected client may move the mount again</source>
        <translation>O cliente selecionado pode mover de novo a montagem</translation>
    </message>
    <message>
        <source>%1: last command %2</source>
        <translation>%1: último comando %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>MQTT broker</source>
        <translation>Broker MQTT</translation>
    </message>
    <message>
        <source>Connected to the MQTT broker %1</source>
        <translation>Ligado ao broker MQTT %1</translation>
    </message>
    <message>
        <source>Connecting to the MQTT broker %1</source>
        <translation>A ligar ao broker MQTT %1</translation>
    </message>
    <message>
        <source>Select a client first.</source>
        <translation>Selecione primeiro um cliente.</translation>
    </message>
    <message>
        <source>The first client moves the mount until it disconnects or commands no motion for 10 s</source>
        <translation>O primeiro cliente move a montagem até não pedir movimento durante 10 s, ou sair</translation>
    </message>
    <message>
        <source>The client that sent the last target moves the mount, as with Hamlib</source>
        <translation>Move a montagem quem enviou o último alvo, como no Hamlib</translation>
    </message>
    <message>
        <source>Only the host of the selected client moves the mount</source>
        <translation>Só o computador de um cliente: selecione-o primeiro</translation>
    </message>
    <message>
        <source>Close the connection. The program may connect again</source>
        <translation>Fecha a ligação. O programa pode ligar-se de novo</translation>
    </message>
    <message>
        <source>Control goes to:</source>
        <translation>Quem move:</translation>
    </message>
    <message>
        <source>The settings for the dialogs of Gpredict</source>
        <translation>Tudo o que o Gpredict precisa saber, para os seus diálogos</translation>
    </message>
    <message>
        <source>rotctld does not listen. No program can connect</source>
        <translation>O rotctld não escuta. Nenhum programa pode ligar-se</translation>
    </message>
    <message>
        <source>Every computer that reaches %1 may connect</source>
        <translation>Quem chegar a %1 pode conectar-se</translation>
    </message>
    <message>
        <source> (next attempt in %1 s)</source>
        <translation> (nova tentativa em %1 s)</translation>
    </message>
    <message>
        <source>You have control. Boresight refuses motion commands of clients</source>
        <translation>O controlo é seu. O Boresight recusa os comandos de movimento dos clientes</translation>
    </message>
    <message>
        <source>Select a client to give it control or to make it read-only</source>
        <translation>Selecione um cliente para lhe dar o controlo ou para o deixar só ler</translation>
    </message>
    <message>
        <source>Apply or revert the edits of the profile first (Ctrl+3).</source>
        <translation>Aplique ou reverta primeiro as alterações do perfil (Ctrl+3).</translation>
    </message>
    <message>
        <source>Control goes to: %1</source>
        <translation>Quem move: %1</translation>
    </message>
    <message>
        <source>%1 (odd commands: %2)</source>
        <translation>%1 (comandos estranhos: %2)</translation>
    </message>
    <message>
        <source>No program is connected. Gpredict disengages after 6 errors in a row. Then press Engage in Gpredict again</source>
        <translation>Nenhum programa está ligado. O Gpredict desliga-se após 6 erros seguidos. Prima então Engage de novo no Gpredict</translation>
    </message>
    <message>
        <source>Boresight tracks %1</source>
        <translation>O Boresight segue %1</translation>
    </message>
    <message>
        <source>Protocol …</source>
        <translation>Protocolo …</translation>
    </message>
    <message>
        <source>Protocol log</source>
        <translation>Registo do protocolo</translation>
    </message>
    <message>
        <source>What the clients send, what Boresight understands and answers</source>
        <translation>O que os clientes enviam, o que o Boresight compreende e responde</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ClosePrompt</name>
    <message>
        <source>Stop the mount and close?</source>
        <translation>Parar a montagem e fechar?</translation>
    </message>
    <message>
        <source>Stopping and closing …</source>
        <translation>A parar e a fechar …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Parar e fechar</translation>
    </message>
    <message>
        <source>Keep open</source>
        <translation>Manter aberto</translation>
    </message>
</context>
<context>
    <name>boresight::ui::CommandButton</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>requested</source>
        <translation>pedido</translation>
    </message>
</context>
<context>
    <name>boresight::ui::CompassDial</name>
    <message>
        <source>Azimuth of the axis and heading of the sensor</source>
        <translation>Azimute do eixo e rumo do sensor</translation>
    </message>
    <message>
        <source>● azimuth of the axis   △ heading of the sensor</source>
        <translation>● azimute do eixo   △ rumo do sensor</translation>
    </message>
    <message>
        <source>axis %1, sensor %2</source>
        <translation>eixo %1, sensor %2</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ControlPrompt</name>
    <message>
        <source>%1 asks for control</source>
        <translation>%1 quer mover</translation>
    </message>
    <message>
        <source>A client asks for control</source>
        <translation>Um cliente quer mover</translation>
    </message>
    <message>
        <source>Allow control</source>
        <translation>Permitir controlo</translation>
    </message>
    <message>
        <source>This client moves the mount from now on (panel Clients, Ctrl+4)</source>
        <translation>Este cliente passa a mover a montagem (painel Clientes, Ctrl+4)</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorar</translation>
    </message>
    <message>
        <source>Boresight does not ask again while this client stays connected</source>
        <translation>O Boresight não pergunta de novo enquanto este cliente estiver conectado</translation>
    </message>
</context>
<context>
    <name>boresight::ui::DeclinationBox</name>
    <message>
        <source>Yes</source>
        <translation>Sim</translation>
    </message>
    <message>
        <source>The headings stay as the sensor sends them</source>
        <translation>Os rumos ficam como o sensor os envia</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Não</translation>
    </message>
    <message>
        <source>Boresight applies the declination of the site in place of the sensor&apos;s</source>
        <translation>O Boresight aplica a declinação do local em vez da do sensor</translation>
    </message>
    <message>
        <source>Where the declination is applied</source>
        <translation>Onde se aplica a declinação</translation>
    </message>
    <message>
        <source>Yes, the sensor applies the declination</source>
        <translation>Sim, o sensor aplica a declinação</translation>
    </message>
    <message>
        <source>No, Boresight applies the declination</source>
        <translation>Não, o Boresight aplica a declinação</translation>
    </message>
    <message>
        <source>Does the sensor apply the declination of this site?</source>
        <translation>O sensor aplica a declinação deste local?</translation>
    </message>
    <message>
        <source>Change the declination</source>
        <translation>Alterar a declinação</translation>
    </message>
    <message>
        <source>Open the settings of the declination on the page Profile</source>
        <translation>Abrir as definições da declinação na página Perfil</translation>
    </message>
    <message>
        <source>Change …</source>
        <translation>Alterar …</translation>
    </message>
</context>
<context>
    <name>boresight::ui::DeviationPlot</name>
    <message>
        <source>%1 samples, first harmonic %2, second %3, scatter %4</source>
        <translation>%1 amostras, primeira harmónica %2, segunda %3, dispersão %4</translation>
    </message>
    <message>
        <source>no swing yet</source>
        <translation>ainda sem giro</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>horário</translation>
    </message>
    <message>
        <source>back</source>
        <translation>volta</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>excluída</translation>
    </message>
    <message>
        <source>unreliable</source>
        <translation>incerto</translation>
    </message>
    <message>
        <source>Compass error</source>
        <translation>Desvio da bússola</translation>
    </message>
    <message>
        <source>Compass error (°) by heading</source>
        <translation>Erro ° por rumo</translation>
    </message>
</context>
<context>
    <name>boresight::ui::DiagnosticsSaver</name>
    <message>
        <source>Save diagnostics</source>
        <translation>Gravar diagnóstico</translation>
    </message>
    <message>
        <source>Archive (*.tar.gz)</source>
        <translation>Arquivo (*.tar.gz)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::DirectionArrow</name>
    <message>
        <source>Direction of the %1</source>
        <translation>Sentido de %1</translation>
    </message>
    <message>
        <source>clockwise, seen from above</source>
        <translation>horário, visto de cima</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>para cima</translation>
    </message>
    <message>
        <source>counter-clockwise, seen from above</source>
        <translation>anti-horário, visto de cima</translation>
    </message>
    <message>
        <source>downwards</source>
        <translation>para baixo</translation>
    </message>
    <message>
        <source>Seen from above: a growing azimuth turns clockwise, from north to east</source>
        <translation>Visto de cima: um azimute crescente gira no sentido horário, do norte para leste</translation>
    </message>
    <message>
        <source>Seen from the side: a growing elevation raises the antenna</source>
        <translation>Visto de lado: uma elevação crescente levanta a antena</translation>
    </message>
    <message>
        <source>standing still</source>
        <translation>parado</translation>
    </message>
</context>
<context>
    <name>boresight::ui::DirectionQuestion</name>
    <message>
        <source>forbidden: %1</source>
        <translation>proibido: %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::DraftTableModel</name>
    <message>
        <source>Az °</source>
        <translation>Az °</translation>
    </message>
    <message>
        <source>El °</source>
        <translation>El °</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>From °</source>
        <translation>De °</translation>
    </message>
    <message>
        <source>To °</source>
        <translation>A °</translation>
    </message>
    <message>
        <source>Min °</source>
        <translation>Mín °</translation>
    </message>
    <message>
        <source>Max °</source>
        <translation>Máx °</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number (decimal point, e.g. 113.5)</source>
        <translation>&quot;%1&quot; não é um número (ponto decimal, p. ex. 113.5)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::DrivesPanel</name>
    <message>
        <source>id %1 (%2, %3)</source>
        <translation>id %1 (%2, %3)</translation>
    </message>
    <message>
        <source>Also on the bus, not in the profile: %1</source>
        <translation>Também no barramento, fora do perfil: %1</translation>
    </message>
    <message>
        <source>%1: stopped after %2 in %3 s, %4</source>
        <translation>%1: parou após %2 em %3 s, %4</translation>
    </message>
    <message>
        <source>another drive, %1</source>
        <translation>outro acionamento, %1</translation>
    </message>
    <message>
        <source>Unknown boards on the bus</source>
        <translation>Placas desconhecidas no barramento</translation>
    </message>
    <message>
        <source>May the mount move</source>
        <translation>A montagem pode mover-se</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Release bus</source>
        <translation>Liberar barramento</translation>
    </message>
    <message>
        <source>Run (both axes) …</source>
        <translation>Ensaiar (2 eixos) …</translation>
    </message>
    <message>
        <source>Run …</source>
        <translation>Ensaiar …</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>UUID</source>
        <translation>UUID</translation>
    </message>
    <message>
        <source>FIRMWARE</source>
        <translation>FIRMWARE</translation>
    </message>
    <message>
        <source>REGISTER MAP</source>
        <translation>REGISTOS</translation>
    </message>
    <message>
        <source>%1 of the %2 drive</source>
        <translation>%1 do acionamento de %2</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Register map</source>
        <translation>Mapa de registos</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>Crash stop of the %1</source>
        <translation>Parada brusca de %1</translation>
    </message>
    <message>
        <source>Take bus back</source>
        <translation>Retomar barramento</translation>
    </message>
    <message>
        <source>known</source>
        <translation>conhecida</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconhecida</translation>
    </message>
    <message>
        <source>Leave the bus while the drives are switched on?</source>
        <translation>Deixar o barramento com os acionamentos ligados?</translation>
    </message>
    <message>
        <source>Leave the bus</source>
        <translation>Deixar o barramento</translation>
    </message>
    <message>
        <source>Move the mount</source>
        <translation>Mover a montagem</translation>
    </message>
    <message>
        <source>Move each axis, stop the commands to its drive, and measure. Boresight asks first.</source>
        <translation>Mover cada eixo, parar as ordens ao acionamento e medir. O Boresight pergunta antes.</translation>
    </message>
    <message>
        <source>Rate of the test</source>
        <translation>Velocidade da prova</translation>
    </message>
    <message>
        <source>Speed of each axis when the commands stop</source>
        <translation>Velocidade de cada eixo quando as ordens param</translation>
    </message>
    <message>
        <source>not tested yet</source>
        <translation>ainda não provada</translation>
    </message>
    <message>
        <source>Crash-stop test</source>
        <translation>Prova de paragem</translation>
    </message>
    <message>
        <source>Crash-stop test: cut the commands, measure the stop</source>
        <translation>Prova de paragem: cortar as ordens, medir a paragem</translation>
    </message>
    <message>
        <source>End test</source>
        <translation>Terminar prova</translation>
    </message>
    <message>
        <source>The drives get no more commands. Each drive follows its setting &quot;If commands stop&quot; (page Protection). With the factory setting an unbalanced elevation sinks slowly.

A drive gives no torque for 53 ms when it is switched on again. An unbalanced elevation then drops a little.</source>
        <translation>Os acionamentos deixam de receber ordens. Cada um segue a sua definição &quot;Se as ordens pararem&quot; (página Proteção). Com a definição de fábrica uma elevação desequilibrada desce devagar.

Um acionamento não dá torque durante 53 ms quando volta a ser ligado. Uma elevação desequilibrada desce então um pouco.</translation>
    </message>
    <message>
        <source>WRAP</source>
        <translation>VOLTA</translation>
    </message>
    <message>
        <source>Cable wrap</source>
        <translation>Volta do cabo</translation>
    </message>
    <message>
        <source>Drive check</source>
        <translation>Verificação dos acionamentos</translation>
    </message>
    <message>
        <source>Send commands to the drives again and hold</source>
        <translation>Enviar de novo comandos aos acionamentos e segurar</translation>
    </message>
    <message>
        <source>Open the adapter again and read the drives again</source>
        <translation>Abrir de novo o adaptador e ler de novo os acionamentos</translation>
    </message>
    <message>
        <source>Move the mount at %1 and stop the commands?</source>
        <translation>Mover a montagem a %1 e cortar as ordens?</translation>
    </message>
    <message>
        <source>Leave the adapter to other tools (tview, moteus_tool). Nothing moves until you take the bus back.</source>
        <translation>Deixar o adaptador a outras ferramentas (tview, moteus_tool). Nada se move até retomar o barramento.</translation>
    </message>
    <message>
        <source>Boresight moves one axis after the other at %1. It stops the commands to the drive, as if the cable were cut. It measures how far and how long the axis still moves.

A drive gives no torque for 53 ms when it is switched on again. An unbalanced elevation then drops a little.

Keep people and ropes clear of the antenna. STOP ends the test.</source>
        <translation>O Boresight move um eixo depois do outro a %1. Para os comandos ao acionamento, como se o cabo fosse cortado. Mede até onde e durante quanto tempo o eixo ainda se move.

Um acionamento não dá binário durante 53 ms quando é ligado de novo. Uma elevação desequilibrada desce então um pouco.

Mantenha pessoas e cordas afastadas da antena. STOP termina o ensaio.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ElementsButton</name>
    <message>
        <source>File …</source>
        <translation>Ficheiro …</translation>
    </message>
    <message>
        <source>Amateur radio (CelesTrak)</source>
        <translation>Radioamadorismo (CelesTrak)</translation>
    </message>
    <message>
        <source>Space stations (CelesTrak)</source>
        <translation>Estações espaciais (CelesTrak)</translation>
    </message>
    <message>
        <source>Weather (CelesTrak)</source>
        <translation>Meteorologia (CelesTrak)</translation>
    </message>
    <message>
        <source>Cubesats (CelesTrak)</source>
        <translation>Cubesats (CelesTrak)</translation>
    </message>
    <message>
        <source>Another address …</source>
        <translation>Outro endereço …</translation>
    </message>
    <message>
        <source>Add elements</source>
        <translation>Adicionar elementos</translation>
    </message>
    <message>
        <source>Enter the site</source>
        <translation>Introduzir o local</translation>
    </message>
    <message>
        <source>Add a file, or a group of CelesTrak</source>
        <translation>Adicionar um ficheiro, ou um grupo do CelesTrak</translation>
    </message>
    <message>
        <source>Open the step Site of the guide</source>
        <translation>Abrir o passo Local do guia</translation>
    </message>
    <message>
        <source>Choose a file with orbital elements</source>
        <translation>Escolher um ficheiro com elementos orbitais</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Elements: %1</source>
        <translation>Elementos: %1</translation>
    </message>
    <message>
        <source>Elements (*.tle *.3le *.txt *.omm *.json *.csv *.xml *.kvn *.sat *.mod)</source>
        <translation>Elementos (*.tle *.3le *.txt *.omm *.json *.csv *.xml *.kvn *.sat *.mod)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ErrorBar</name>
    <message>
        <source>%1 beam widths</source>
        <translation>%1 larguras de feixe</translation>
    </message>
    <message>
        <source>Error in beam widths. The middle is the target. Each end is one beam width.</source>
        <translation>Erro em larguras de feixe. O meio é o alvo. Cada extremo é uma largura de feixe.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ErrorCorner</name>
    <message>
        <source>total %1</source>
        <translation>total %1</translation>
    </message>
    <message>
        <source>total ≥%1</source>
        <translation>total ≥%1</translation>
    </message>
    <message>
        <source>Distance to the target</source>
        <translation>Distância ao alvo</translation>
    </message>
    <message>
        <source>off by</source>
        <translation>desvio</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>Desvio</translation>
    </message>
    <message>
        <source>Pointing loss</source>
        <translation>Perda de apontamento</translation>
    </message>
    <message>
        <source>Total of the error budget</source>
        <translation>Total do balanço de erros</translation>
    </message>
    <message>
        <source>Loss of power by the pointing error. It is shown up to one beam width.</source>
        <translation>Perda de potência pelo erro de apontamento. É indicada até uma largura de feixe.</translation>
    </message>
    <message>
        <source>The angle on the sky between the target and the direction of the mount</source>
        <translation>O ângulo no céu entre o alvo e a direção da montagem</translation>
    </message>
</context>
<context>
    <name>boresight::ui::FavouriteButton</name>
    <message>
        <source>Add to favourites</source>
        <translation>Juntar aos favoritos</translation>
    </message>
    <message>
        <source>Remove from favourites</source>
        <translation>Tirar dos favoritos</translation>
    </message>
    <message>
        <source>Give this satellite a star and a place in the timeline (Space in the table)</source>
        <translation>Dar a este satélite uma estrela e um lugar na linha do tempo (Espaço na tabela)</translation>
    </message>
    <message>
        <source>Select a pass first.</source>
        <translation>Escolha primeiro uma passagem.</translation>
    </message>
    <message>
        <source>Remove the star of this satellite (Space in the table)</source>
        <translation>Retirar a estrela deste satélite (Espaço na tabela)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::FiguresModel</name>
    <message>
        <source>Figure</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Depois</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GainsModel</name>
    <message>
        <source>Gain</source>
        <translation>Ganho</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Agora</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Intervalo</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GainsPage</name>
    <message>
        <source>Gains of the drive</source>
        <translation>Ganhos do acionamento</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Ler</translation>
    </message>
    <message>
        <source>Read the gains of this drive. Nothing moves</source>
        <translation>Ler os ganhos deste acionamento. Nada se move</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escrever</translation>
    </message>
    <message>
        <source>Write this value and read it back. In force until a power cycle</source>
        <translation>Escrever este valor e relê-lo. Em vigor até desligar a alimentação</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Repor</translation>
    </message>
    <message>
        <source>Store …</source>
        <translation>Guardar …</translation>
    </message>
    <message>
        <source>New value of the selected gain</source>
        <translation>Novo valor do ganho selecionado</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Ganhos</translation>
    </message>
    <message>
        <source>On trial, not stored: %1</source>
        <translation>À experiência, não guardado: %1</translation>
    </message>
    <message>
        <source>Select a gain in the table first.</source>
        <translation>Selecione primeiro um ganho na tabela.</translation>
    </message>
    <message>
        <source>Select a gain to change it.</source>
        <translation>Selecione um ganho para o alterar.</translation>
    </message>
    <message>
        <source>Write the encoder filter?</source>
        <translation>Escrever o filtro do codificador?</translation>
    </message>
    <message>
        <source>Store the gains in the %1 drive?</source>
        <translation>Guardar os ganhos no acionamento de %1?</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Limits of the selected gain</source>
        <translation>Limites do ganho selecionado</translation>
    </message>
    <message>
        <source>Write the gains that were read first</source>
        <translation>Escrever os ganhos lidos em primeiro lugar</translation>
    </message>
    <message>
        <source>Store the gains in the drive permanently. Asks first</source>
        <translation>Guardar os ganhos no acionamento de forma permanente. Pergunta primeiro</translation>
    </message>
    <message>
        <source>The gains of this drive have not been read.</source>
        <translation>Os ganhos deste acionamento ainda não foram lidos.</translation>
    </message>
    <message>
        <source>This value is in force. Enter another one first.</source>
        <translation>Este valor está em vigor. Introduza outro primeiro.</translation>
    </message>
    <message>
        <source>With another filter the drive counts its position from a new zero. The cable wrap of the %1 is unknown until you enter the position. Nothing moves.</source>
        <translation>Com outro filtro o acionamento conta a posição a partir de um novo zero. A volta do cabo do %1 fica desconhecida até indicar a posição. Nada se move.</translation>
    </message>
    <message>
        <source>
The drive keeps these gains after a power cycle. It also stores all its other present settings. Nothing moves.</source>
        <translation>
O acionamento mantém estes ganhos depois de desligado e ligado. Guarda também todas as suas outras definições atuais. Nada se move.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::Gamepad</name>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GoToBar</name>
    <message>
        <source>Azimuth</source>
        <translation>Azimute</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevação</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Ir</translation>
    </message>
    <message>
        <source>Recent directions</source>
        <translation>Direções recentes</translation>
    </message>
    <message>
        <source>Az</source>
        <translation>Az</translation>
    </message>
    <message>
        <source>El</source>
        <translation>El</translation>
    </message>
    <message>
        <source>az %1°  el %2°</source>
        <translation>az %1°  el %2°</translation>
    </message>
    <message>
        <source>%1 in degrees, for example 113.5 (Ctrl+G, then Enter to go)</source>
        <translation>%1 em graus, por exemplo 113.5 (Ctrl+G, depois Enter para ir)</translation>
    </message>
    <message>
        <source>Go to this direction by the shortest way (Enter)</source>
        <translation>Ir para esta direção pelo caminho mais curto (Enter)</translation>
    </message>
    <message>
        <source>Copy a recent direction into the fields. Nothing moves before Go.</source>
        <translation>Copiar uma direção recente para os campos. Nada se move antes de Ir.</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Ir a</translation>
    </message>
    <message>
        <source>Go: The azimuth is not a number. Type it with a decimal point, for example 113.5.</source>
        <translation>Ir: O azimute não é um número. Escreva-o com ponto decimal, por exemplo 113.5.</translation>
    </message>
    <message>
        <source>Go: The elevation is not a number. Type it with a decimal point, for example 10.5.</source>
        <translation>Ir: A elevação não é um número. Escreva-a com ponto decimal, por exemplo 10.5.</translation>
    </message>
    <message>
        <source>Go: Enter an azimuth, an elevation or both.</source>
        <translation>Ir: Indique um azimute, uma elevação ou ambos.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GroundMap</name>
    <message>
        <source>Ground track of the satellite</source>
        <translation>Percurso do satélite sobre a Terra</translation>
    </message>
    <message>
        <source>Over latitude %1, longitude %2, %3 km high</source>
        <translation>Sobre a latitude %1, longitude %2, a %3 km de altura</translation>
    </message>
    <message>
        <source>Thick line: the pass. Thin line: the orbit after it. Places inside the dashed circle see the satellite now.</source>
        <translation>Linha grossa: a passagem. Linha fina: a órbita depois dela. Os lugares dentro do círculo tracejado veem o satélite agora.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideBoards</name>
    <message>
        <source>id %1, UUID unread</source>
        <translation>id %1, UUID não lido</translation>
    </message>
    <message>
        <source>id %1, UUID %2</source>
        <translation>id %1, UUID %2</translation>
    </message>
    <message>
        <source>What to do with the boards</source>
        <translation>O que fazer com as placas</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Give this board the id %1?</source>
        <translation>Dar a esta placa o id %1?</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escrever</translation>
    </message>
    <message>
        <source>Assign to azimuth …</source>
        <translation>Atribuir ao azimute …</translation>
    </message>
    <message>
        <source>Give the only connected board the id of the azimuth. Asks first</source>
        <translation>Dar à única placa ligada o id do azimute. Pergunta antes</translation>
    </message>
    <message>
        <source>Assign to elevation …</source>
        <translation>Atribuir à elevação …</translation>
    </message>
    <message>
        <source>Give the only connected board the id of the elevation. Asks first</source>
        <translation>Dar à única placa ligada o id da elevação. Pergunta antes</translation>
    </message>
    <message>
        <source>Two boards have the same id, as from the factory. Their replies collide. Switch the power off. Disconnect one board. Leave the board connected that needs another id. Switch the power on. This page continues when that board answers.</source>
        <translation>Duas placas têm o mesmo id, como vêm de fábrica. As respostas colidem. Desligue a alimentação. Desligue uma placa. Deixe ligada a placa que precisa de outro id. Ligue a alimentação. Esta página continua quando essa placa responder.</translation>
    </message>
    <message>
        <source>One board replies: %1. If the other board is connected, check its power and plugs. If both boards had the same id, choose the axis of this board. Boresight then sets the id of that axis.</source>
        <translation>Responde uma placa: %1. Se a outra placa estiver ligada, verifique a alimentação e as fichas dela. Se as duas placas tinham o mesmo id, escolha o eixo desta placa. O Boresight define então o id desse eixo.</translation>
    </message>
    <message>
        <source>Board: %1.
Axis: %2. New id: %3.

Boresight sets the id. It checks that the same board replies. It reads the id back and stores it. If a check fails, Boresight stores nothing. Nothing moves.</source>
        <translation>Placa: %1.
Eixo: %2. Novo id: %3.

O Boresight define o id. Verifica se responde a mesma placa. Volta a ler o id e guarda-o. Se uma verificação falhar, o Boresight não guarda nada. Nada se move.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideClient</name>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Programs that are connected</source>
        <translation>Programas conectados</translation>
    </message>
    <message>
        <source>Settings for Gpredict</source>
        <translation>Configuração para o Gpredict</translation>
    </message>
    <message>
        <source>Copy the settings for Gpredict</source>
        <translation>Copiar a configuração para o Gpredict</translation>
    </message>
    <message>
        <source>Put the settings for Gpredict into the clipboard</source>
        <translation>Pôr a configuração para o Gpredict na área de transferência</translation>
    </message>
    <message>
        <source>Any other client of rotctld works as well, at the same address.</source>
        <translation>Qualquer outro cliente de rotctld também serve, no mesmo endereço.</translation>
    </message>
    <message>
        <source>No program is connected yet</source>
        <translation>Ainda nenhum programa está conectado</translation>
    </message>
    <message>
        <source>Connected: %1</source>
        <translation>Conectados: %1</translation>
    </message>
    <message>
        <source>The rotctld port is closed. No program can connect. The alarm shows the reason.</source>
        <translation>A porta rotctld está fechada. Nenhum programa pode ligar-se. O alarme mostra o motivo.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideConnect</name>
    <message>
        <source>id %1: %2, %3, firmware %4</source>
        <translation>id %1: %2, %3, firmware %4</translation>
    </message>
    <message>
        <source>%1, id %2: no answer</source>
        <translation>%1, id %2: sem resposta</translation>
    </message>
    <message>
        <source>%1, id %2: %3, %4</source>
        <translation>%1, id %2: %3, %4</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Atualizar</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Procurar</translation>
    </message>
    <message>
        <source>List the drives on the selected bus. Nothing moves</source>
        <translation>Listar os acionamentos no barramento selecionado. Nada se move</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Connect to the mount by the selected adapter</source>
        <translation>Conectar-se à montagem pelo adaptador selecionado</translation>
    </message>
    <message>
        <source>Adapters of this computer</source>
        <translation>Adaptadores deste computador</translation>
    </message>
    <message>
        <source>Who answers</source>
        <translation>Quem responde</translation>
    </message>
    <message>
        <source>List the adapters again, after one was plugged in</source>
        <translation>Listar de novo os adaptadores, depois de conectar um</translation>
    </message>
    <message>
        <source>%1 (unknown to Boresight)</source>
        <translation>%1 (desconhecido do Boresight)</translation>
    </message>
    <message>
        <source>Select an adapter first.</source>
        <translation>Selecione primeiro um adaptador.</translation>
    </message>
    <message>
        <source>Boresight is scanning %1. Wait a moment.</source>
        <translation>O Boresight está a examinar %1. Aguarde um momento.</translation>
    </message>
    <message>
        <source>The mount is already connected by this adapter.</source>
        <translation>A montagem já está conectada por este adaptador.</translation>
    </message>
    <message>
        <source>In use. %1.</source>
        <translation>Em uso. %1.</translation>
    </message>
    <message>
        <source>id %1: not in the profile</source>
        <translation>id %1: fora do perfil</translation>
    </message>
    <message>
        <source>Scanning …</source>
        <translation>A procurar …</translation>
    </message>
    <message>
        <source>Press Scan to list the drives on this bus. Scanning moves nothing.</source>
        <translation>Clique em Procurar para listar os acionamentos neste barramento. Procurar não move nada.</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1 (simulado)</translation>
    </message>
    <message>
        <source>SIMULATED  ·  %1</source>
        <translation>SIMULADO  ·  %1</translation>
    </message>
    <message>
        <source>In use. This rotator has no boards that can be listed.</source>
        <translation>Em uso. Este rotor não tem placas que se possam listar.</translation>
    </message>
    <message>
        <source>This rotator is already connected.</source>
        <translation>Este rotor já está ligado.</translation>
    </message>
    <message>
        <source>These settings are in force. Press Reconnect to try again (tab Mount, Profile).</source>
        <translation>Estas definições estão em vigor. Carregue em Reconectar para tentar outra vez (separador Montagem, Perfil).</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideDirections</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>The other axis moved:
swap the motors</source>
        <translation>Moveu-se o outro eixo:
trocar os motores</translation>
    </message>
    <message>
        <source>Test move</source>
        <translation>Movimento de teste</translation>
    </message>
    <message>
        <source>AZ ↺
(hold)</source>
        <translation>AZ ↺
(segurar)</translation>
    </message>
    <message>
        <source>AZ ↻
(hold)</source>
        <translation>AZ ↻
(segurar)</translation>
    </message>
    <message>
        <source>EL ↓
(hold)</source>
        <translation>EL ↓
(segurar)</translation>
    </message>
    <message>
        <source>Lower elevation at %1 while held</source>
        <translation>Baixar a elevação a %1 enquanto premido</translation>
    </message>
    <message>
        <source>EL ↑
(hold)</source>
        <translation>EL ↑
(segurar)</translation>
    </message>
    <message>
        <source>Raise elevation at %1 while held</source>
        <translation>Subir a elevação a %1 enquanto premido</translation>
    </message>
    <message>
        <source>Test move of the %1</source>
        <translation>Movimento de teste de %1</translation>
    </message>
    <message>
        <source>↻ must turn the antenna clockwise, seen from above</source>
        <translation>↻ tem de girar a antena no sentido horário, visto de cima</translation>
    </message>
    <message>
        <source>↑ must raise the antenna</source>
        <translation>↑ tem de levantar a antena</translation>
    </message>
    <message>
        <source>%1. Now %2.</source>
        <translation>%1. Agora %2.</translation>
    </message>
    <message>
        <source>it is confirmed already</source>
        <translation>já está confirmado</translation>
    </message>
    <message>
        <source>move the %1 a little first, and look at it</source>
        <translation>mova primeiro um pouco o eixo de %1, e observe-o</translation>
    </message>
    <message>
        <source>only one axis has a motor that can be exchanged</source>
        <translation>só um eixo tem um motor que se pode trocar</translation>
    </message>
    <message>
        <source>Azimuth and elevation exchange their motors. Boresight connects again.</source>
        <translation>Azimute e elevação trocam os motores. O Boresight volta a ligar.</translation>
    </message>
    <message>
        <source>Both directions are right</source>
        <translation>Os dois sentidos estão certos</translation>
    </message>
    <message>
        <source>AZ moved the wrong way</source>
        <translation>AZ moveu-se ao contrário</translation>
    </message>
    <message>
        <source>EL moved the wrong way</source>
        <translation>EL moveu-se ao contrário</translation>
    </message>
    <message>
        <source>The direction is right</source>
        <translation>O sentido está certo</translation>
    </message>
    <message>
        <source>The motor of the %1 counts the other way. Boresight connects again.</source>
        <translation>O motor do %1 conta para o outro lado. O Boresight liga-se de novo.</translation>
    </message>
    <message>
        <source>From now on the mount may move faster and farther</source>
        <translation>A partir de agora a montagem pode mover-se mais depressa e mais longe</translation>
    </message>
    <message>
        <source>If a direction is wrong</source>
        <translation>Se um sentido estiver errado</translation>
    </message>
    <message>
        <source>The box of the rotator decides the direction. If an axis moves the wrong way, reverse it at its motor or at the box.</source>
        <translation>É a caixa do rotor que decide o sentido. Se um eixo se mover no sentido errado, inverta-o no motor ou na caixa.</translation>
    </message>
    <message>
        <source>Turn azimuth counter-clockwise at %1 while held</source>
        <translation>Girar o azimute no sentido anti-horário a %1 enquanto premido</translation>
    </message>
    <message>
        <source>Turn azimuth clockwise at %1 while held</source>
        <translation>Girar o azimute no sentido horário a %1 enquanto premido</translation>
    </message>
    <message>
        <source>X: AZ ↻ must lean the antenna to azimuth %1</source>
        <translation>X: AZ ↻ tem de inclinar a antena para o azimute %1</translation>
    </message>
    <message>
        <source>Y: EL ↑ must lean the antenna to azimuth %1</source>
        <translation>Y: EL ↑ tem de inclinar a antena para o azimute %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideNorth</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>O que fazer</translation>
    </message>
    <message>
        <source>Where the antenna points now</source>
        <translation>Para onde a antena aponta agora</translation>
    </message>
    <message>
        <source>What the change does</source>
        <translation>O que a mudança faz</translation>
    </message>
    <message>
        <source>True azimuth of the antenna</source>
        <translation>Azimute verdadeiro da antena</translation>
    </message>
    <message>
        <source>The direction the antenna points to, from true north</source>
        <translation>A direção para que a antena aponta, a partir do norte verdadeiro</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Set north</source>
        <translation>Definir norte</translation>
    </message>
    <message>
        <source>Sensor, Sun, Moon (Ctrl+9)</source>
        <translation>Sensor, Sol, Lua (Ctrl+9)</translation>
    </message>
    <message>
        <source>Moves the %1 slowly while held</source>
        <translation>Move o eixo de %1 devagar enquanto premido</translation>
    </message>
    <message>
        <source>North is known: azimuth offset %1, from &quot;%2&quot; of %3.</source>
        <translation>O norte é conhecido: desvio de azimute %1, de &quot;%2&quot; de %3.</translation>
    </message>
    <message>
        <source>North is known: azimuth offset %1, set by hand.</source>
        <translation>O norte é conhecido: desvio de azimute %1, posto à mão.</translation>
    </message>
    <message>
        <source>Replace the known north</source>
        <translation>Substituir o norte conhecido</translation>
    </message>
    <message>
        <source>Sun, Moon (Ctrl+9)</source>
        <translation>Sol, Lua (Ctrl+9)</translation>
    </message>
    <message>
        <source>Press Confirm to keep it. To replace it, type the true azimuth of the antenna.</source>
        <translation>Prima Confirmar para o manter. Para o substituir, escreva o azimute verdadeiro da antena.</translation>
    </message>
    <message>
        <source>Set the azimuth offset of the pointing model. Nothing moves.</source>
        <translation>Definir o desvio de azimute do modelo de apontamento. Nada se move.</translation>
    </message>
    <message>
        <source>The azimuth offset changes from %1 to %2 at once. Nothing moves. Travel, cable and park keep their numbers. Horizon and keep-outs keep their true directions. To go back, press Undo on the page Profile.</source>
        <translation>O desvio de azimute muda de %1 para %2 de imediato. Nada se move. Curso, cabo e estacionamento mantêm os números. Horizonte e zonas proibidas mantêm as direções verdadeiras. Para voltar atrás, prima Desfazer na página Perfil.</translation>
    </message>
    <message>
        <source>The mount reports %1</source>
        <translation>A montagem indica %1</translation>
    </message>
    <message>
        <source>Point the antenna at a landmark with a known bearing, and type the bearing. Or use the Sun or the Moon. This mount has no sensor. To find north later, press Next. Everything else works without north.</source>
        <translation>Aponte a antena para um marco de azimute conhecido e escreva esse azimute. Ou use o Sol ou a Lua. Esta montagem não tem sensor. Para achar o norte mais tarde, prima Seguinte. Tudo o resto funciona sem o norte.</translation>
    </message>
    <message>
        <source>Point the antenna at a landmark with a known bearing, and type the bearing. Or use the sensor, the Sun or the Moon. To find north later, press Next. Everything else works without north.</source>
        <translation>Aponte a antena para um marco de azimute conhecido e escreva esse azimute. Ou use o sensor, o Sol ou a Lua. Para achar o norte mais tarde, prima Seguinte. Tudo o resto funciona sem o norte.</translation>
    </message>
    <message>
        <source>Find north on the panel North. F3 returns to this step.</source>
        <translation>Encontre o norte no painel Norte. F3 volta a este passo.</translation>
    </message>
    <message>
        <source>True azimuth</source>
        <translation>Azimute verdadeiro</translation>
    </message>
    <message>
        <source>An X/Y mount needs no north. The profile has the direction of the X axis (mount.x_axis_deg). Press Next.</source>
        <translation>Uma montagem X/Y não precisa de norte. O perfil tem a direção do eixo X (mount.x_axis_deg). Prima Seguinte.</translation>
    </message>
    <message>
        <source>The direction of the X axis of an X/Y mount is a setting of the profile.</source>
        <translation>A direção do eixo X de uma montagem X/Y é uma definição do perfil.</translation>
    </message>
    <message>
        <source>The antenna points up. Lower it first.</source>
        <translation>A antena aponta para cima. Baixe-a primeiro.</translation>
    </message>
    <message>
        <source>Antenna &quot;%1&quot; is in use. Choose &quot;main&quot; first.</source>
        <translation>A antena &quot;%1&quot; está em uso. Escolha primeiro &quot;main&quot;.</translation>
    </message>
    <message>
        <source>Type the true azimuth first.</source>
        <translation>Escreva primeiro o azimute verdadeiro.</translation>
    </message>
    <message>
        <source>North is known. Tick &quot;Replace the known north&quot; first.</source>
        <translation>O norte é conhecido. Marque primeiro &quot;Substituir o norte conhecido&quot;.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuidePage</name>
    <message>
        <source>Step of the guide</source>
        <translation>Passo do guia</translation>
    </message>
    <message>
        <source>What is in the way</source>
        <translation>O que impede</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Voltar</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Seguinte</translation>
    </message>
    <message>
        <source>Finish later</source>
        <translation>Terminar depois</translation>
    </message>
    <message>
        <source>Commissioning guide</source>
        <translation>Guia de instalação</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Confirmar</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Leave the guide. F3 opens it again</source>
        <translation>Sair do guia. F3 volta a abri-lo</translation>
    </message>
    <message>
        <source>This step is done. Go to the next one (Alt+Right)</source>
        <translation>Este passo está feito. Ir para o seguinte (Alt+Direita)</translation>
    </message>
    <message>
        <source>%1 Next marks this step as skipped (Alt+Right).</source>
        <translation>%1 Seguinte marca este passo como saltado (Alt+Direita).</translation>
    </message>
    <message>
        <source>This step is done</source>
        <translation>Este passo está feito</translation>
    </message>
    <message>
        <source>Confirm: %1</source>
        <translation>Confirmar: %1</translation>
    </message>
    <message>
        <source>Show the panels. F3 returns to this step.</source>
        <translation>Mostrar os painéis. F3 volta a este passo.</translation>
    </message>
    <message>
        <source>The cable wrap of the %1 is unknown. Press Ctrl+9 to enter it. F3 returns here</source>
        <translation>A volta do cabo do %1 é desconhecida. Prima Ctrl+9 para a indicar. F3 volta aqui</translation>
    </message>
    <message>
        <source>To the previous step (Alt+Left)</source>
        <translation>Para o passo anterior (Alt+Esquerda)</translation>
    </message>
    <message>
        <source>Nothing may move before step %1 (%2) is done: %3</source>
        <translation>Nada se pode mover antes de o passo %1 (%2) estar feito: %3</translation>
    </message>
    <message>
        <source>The position of the %1 is unknown. Press Ctrl+9 to enter it. F3 returns here</source>
        <translation>A posição do %1 é desconhecida. Prima Ctrl+9 para a indicar. F3 volta aqui</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideReady</name>
    <message>
        <source>Not ready: one step needs you.</source>
        <translation>Não está pronto: um passo precisa de si.</translation>
    </message>
    <message>
        <source>Not ready: %1 steps need you.</source>
        <translation>Não está pronto: %1 passos precisam de si.</translation>
    </message>
    <message>
        <source>Every step is done.</source>
        <translation>Todos os passos estão feitos.</translation>
    </message>
    <message>
        <source>Done: %1. Skipped: %2. To do: %3. Press a step to go back to it.</source>
        <translation>Feitos: %1. Saltados: %2. Por fazer: %3. Prima um passo para voltar a ele.</translation>
    </message>
    <message>
        <source>azimuth %1</source>
        <translation>azimute %1</translation>
    </message>
    <message>
        <source>elevation %1</source>
        <translation>elevação %1</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>O que está feito</translation>
    </message>
    <message>
        <source>Line for Gpredict</source>
        <translation>Linha para o Gpredict</translation>
    </message>
    <message>
        <source>What to do for the first pass</source>
        <translation>O que fazer para a primeira passagem</translation>
    </message>
    <message>
        <source>After the pass</source>
        <translation>Depois da passagem</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the line for Gpredict</source>
        <translation>Copiar a linha para o Gpredict</translation>
    </message>
    <message>
        <source>Put the settings for Gpredict into the clipboard</source>
        <translation>Copiar as definições do Gpredict para a área de transferência</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>Ainda não: %1</translation>
    </message>
    <message>
        <source>After the pass, Park (Ctrl+P) moves the mount to %1. To stop it at any time, press STOP, Pause or F12. The mast also needs a hard-wired emergency stop.</source>
        <translation>Depois da passagem: Estacionar (Ctrl+P) vai para %1. STOP: o botão, Pause ou F12, a qualquer momento. O mastro precisa também de uma paragem de emergência por fios.</translation>
    </message>
    <message>
        <source>Why the mount cannot point now</source>
        <translation>Porque não se pode apontar a montagem agora</translation>
    </message>
    <message>
        <source>%1 This is the simulated mount. A real mount starts at step 1.</source>
        <translation>%1 Esta é a montagem simulada. Uma real começa de novo.</translation>
    </message>
    <message>
        <source>Open Antenna Control in Gpredict. Choose the satellite. Press Track, then Engage. The state becomes TRACK.</source>
        <translation>No Gpredict abra Antenna Control. Escolha o satélite. Prima Track e depois Engage. O estado passa a RASTREIO.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideSite</name>
    <message>
        <source>What is wrong</source>
        <translation>O que está errado</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Degrees, north positive</source>
        <translation>Graus, norte positivo</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>Degrees, east positive</source>
        <translation>Graus, leste positivo</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altitude</translation>
    </message>
    <message>
        <source>Above sea level</source>
        <translation>Acima do nível do mar</translation>
    </message>
    <message>
        <source>Set the site</source>
        <translation>Definir o local</translation>
    </message>
    <message>
        <source>Maidenhead locator</source>
        <translation>Localizador Maidenhead</translation>
    </message>
    <message>
        <source>Station of Gpredict</source>
        <translation>Estação do Gpredict</translation>
    </message>
    <message>
        <source>Latitude (north +)</source>
        <translation>Latitude (N +)</translation>
    </message>
    <message>
        <source>Longitude (east +)</source>
        <translation>Longitude (E +)</translation>
    </message>
    <message>
        <source>Locator</source>
        <translation>Localizador</translation>
    </message>
    <message>
        <source>From Gpredict</source>
        <translation>Do Gpredict</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>nenhuma encontrada</translation>
    </message>
    <message>
        <source>choose …</source>
        <translation>escolher …</translation>
    </message>
    <message>
        <source>this is the site in the profile</source>
        <translation>este é o local do perfil</translation>
    </message>
    <message>
        <source>less than a day</source>
        <translation>menos de um dia</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 dias</translation>
    </message>
    <message>
        <source>%1: no satellite data</source>
        <translation>%1: sem dados de satélites</translation>
    </message>
    <message>
        <source>%1: satellites %2, the newest elements %3 old</source>
        <translation>%1: satélites %2, os elementos mais novos têm %3</translation>
    </message>
    <message>
        <source>%1: satellites %2, none with elements that can be read</source>
        <translation>%1: satélites %2, nenhum com elementos legíveis</translation>
    </message>
    <message>
        <source>Folder …</source>
        <translation>Pasta …</translation>
    </message>
    <message>
        <source>Where Gpredict keeps its files, if not at the usual place</source>
        <translation>Onde o Gpredict guarda os seus ficheiros, se não for no lugar habitual</translation>
    </message>
    <message>
        <source>Where Gpredict keeps its files</source>
        <translation>Onde o Gpredict guarda os seus ficheiros</translation>
    </message>
    <message>
        <source>4 to 10 characters, for example JN58td. The place is the middle of this square.</source>
        <translation>4 a 10 caracteres, por exemplo JN58td. O lugar é o meio deste quadrado.</translation>
    </message>
    <message>
        <source>Ground stations of Gpredict on this computer. Choose one to fill in the fields.</source>
        <translation>Estações terrestres do Gpredict neste computador. Escolha uma para preencher os campos.</translation>
    </message>
    <message>
        <source>%1: No Gpredict settings found. Choose its folder.</source>
        <translation>%1: Não há definições do Gpredict. Escolha a pasta.</translation>
    </message>
    <message>
        <source>Sites found in Gpredict</source>
        <translation>Locais encontrados no Gpredict</translation>
    </message>
    <message>
        <source>Store this place in the profile</source>
        <translation>Guardar este lugar no perfil</translation>
    </message>
    <message>
        <source>enter the site of the mount first</source>
        <translation>introduza primeiro o local da montagem</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideTravel</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Use these ends</source>
        <translation>Usar estes fins</translation>
    </message>
    <message>
        <source>What the ends are</source>
        <translation>O que são os fins</translation>
    </message>
    <message>
        <source>%1, a mechanical angle</source>
        <translation>%1, um ângulo mecânico</translation>
    </message>
    <message>
        <source>Lower end of %1</source>
        <translation>Fim inferior de %1</translation>
    </message>
    <message>
        <source>Upper end of %1</source>
        <translation>Fim superior de %1</translation>
    </message>
    <message>
        <source>from </source>
        <translation>de </translation>
    </message>
    <message>
        <source>to </source>
        <translation>a </translation>
    </message>
    <message>
        <source>lower</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Towards the lower end of %1 while held</source>
        <translation>Para o fim inferior de %1 enquanto premido</translation>
    </message>
    <message>
        <source>Towards the upper end of %1 while held</source>
        <translation>Para o fim superior de %1 enquanto premido</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Aqui</translation>
    </message>
    <message>
        <source>Set the %1 end of %2 here</source>
        <translation>Marcar aqui o fim %1 de %2</translation>
    </message>
    <message>
        <source>these are the ends in force</source>
        <translation>estes são os fins em vigor</translation>
    </message>
    <message>
        <source>Travel of the %1. The pointer shows where it is now.</source>
        <translation>Curso de %1. O ponteiro mostra onde está agora.</translation>
    </message>
    <message>
        <source>Write these ends into the profile and connect again. Then fix the limits of the drives (step Protect).</source>
        <translation>Escrever estes fins no perfil e voltar a ligar. Depois corrija os limites dos acionamentos (passo Proteção).</translation>
    </message>
    <message>
        <source>Write these ends into the profile and connect again. Nothing moves.</source>
        <translation>Escrever estes fins no perfil e ligar de novo. Nada se move.</translation>
    </message>
    <message>
        <source>The %1 end of %2 is the present position of the axis</source>
        <translation>O fim %1 de %2 é a posição atual do eixo</translation>
    </message>
    <message>
        <source>Type the ends, or jog to each end and set it here. Whole turns count: 370° is not 10°.</source>
        <translation>Escreva os extremos, ou vá até cada extremo por jog e defina-o aqui. As voltas inteiras contam: 370° não é 10°.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::GuideZero</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>O que fazer</translation>
    </message>
    <message>
        <source>What the change does</source>
        <translation>O que a mudança faz</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>True elevation of the antenna</source>
        <translation>Elevação verdadeira da antena</translation>
    </message>
    <message>
        <source>By a spirit level on the antenna: 0° is level</source>
        <translation>Com um nível de bolha na antena: 0° é nivelado</translation>
    </message>
    <message>
        <source>Bring the antenna level, by a spirit level on it, and set 0° here. Or type what an inclinometer shows.</source>
        <translation>Nivele a antena com um nível de bolha e marque 0° aqui. Ou escreva o que mostra um inclinômetro.</translation>
    </message>
    <message>
        <source>Moves the %1 slowly while held</source>
        <translation>Move o eixo de %1 devagar enquanto premido</translation>
    </message>
    <message>
        <source>travel %1, now %2</source>
        <translation>curso %1, agora %2</translation>
    </message>
    <message>
        <source>The drives&apos; own bounds stay right.</source>
        <translation>Os limites dos próprios acionamentos continuam certos.</translation>
    </message>
    <message>
        <source>Every angle changes by %1: %2. %3</source>
        <translation>Cada ângulo muda %1: %2. %3</translation>
    </message>
    <message>
        <source>Write the new zero into the profile and connect again. Nothing moves.</source>
        <translation>Escrever o novo zero no perfil e voltar a ligar. Nada se move.</translation>
    </message>
    <message>
        <source>Keep cable and stops physically where they are</source>
        <translation>Manter cabo e batentes onde estão fisicamente</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Definir</translation>
    </message>
    <message>
        <source>True value</source>
        <translation>Valor verdadeiro</translation>
    </message>
    <message>
        <source>Shown %1</source>
        <translation>Mostrado %1</translation>
    </message>
    <message>
        <source>The angle that the %1 reports now</source>
        <translation>O ângulo que o %1 indica agora</translation>
    </message>
    <message>
        <source>Then fix the limits of the drives (step Protect).</source>
        <translation>Depois corrija os limites dos acionamentos (passo Proteção).</translation>
    </message>
    <message>
        <source>Bring the antenna level, by a spirit level on it. The box of the rotator must show 0° then. If not, calibrate the box.</source>
        <translation>Ponha a antena na horizontal, com um nível de bolha. A caixa do rotor tem então de indicar 0°. Se não, calibre a caixa.</translation>
    </message>
    <message>
        <source>Off: the ends keep their angles, so they move to other places of the mount</source>
        <translation>Desligado: os fins mantêm os seus ângulos, por isso mudam para outros lugares da montagem</translation>
    </message>
</context>
<context>
    <name>boresight::ui::HandBackPrompt</name>
    <message>
        <source>Clients are waiting</source>
        <translation>Há clientes à espera</translation>
    </message>
    <message>
        <source>Clients are waiting. Hand back?</source>
        <translation>Há clientes à espera. Devolver?</translation>
    </message>
    <message>
        <source>Hand back</source>
        <translation>Devolver</translation>
    </message>
    <message>
        <source>Clients move the mount from now on</source>
        <translation>A partir de agora os clientes movem a montagem</translation>
    </message>
    <message>
        <source>Keep control</source>
        <translation>Manter controlo</translation>
    </message>
    <message>
        <source>Boresight still refuses clients. Hand over later on the Clients page</source>
        <translation>O Boresight continua a recusar clientes. Entregue mais tarde na página Clientes</translation>
    </message>
</context>
<context>
    <name>boresight::ui::HeaderBar</name>
    <message>
        <source>rotctld does not listen</source>
        <translation>o rotctld não escuta</translation>
    </message>
    <message>
        <source>rotctld listens on %1</source>
        <translation>o rotctld escuta em %1</translation>
    </message>
    <message>
        <source>, last command %1</source>
        <translation>, último comando %1</translation>
    </message>
    <message>
        <source>Station state</source>
        <translation>Estado da estação</translation>
    </message>
    <message>
        <source>Reason of the state</source>
        <translation>Razão do estado</translation>
    </message>
    <message>
        <source>Target limited</source>
        <translation>Alvo limitado</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>Simulated mount</source>
        <translation>Montagem simulada</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULADO</translation>
    </message>
    <message>
        <source>no target</source>
        <translation>sem alvo</translation>
    </message>
    <message>
        <source>there in %1 s</source>
        <translation>lá dentro de %1 s</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>por %1</translation>
    </message>
    <message>
        <source>clients</source>
        <translation>clientes</translation>
    </message>
    <message>
        <source>you</source>
        <translation>operador</translation>
    </message>
    <message>
        <source>Control: %1</source>
        <translation>Controlo: %1</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Menu: theme, full screen, language, guide, keys, diagnostics (F10 or Alt)</source>
        <translation>Menu: tema, ecrã inteiro, idioma, guia, teclas, diagnóstico (F10 ou Alt)</translation>
    </message>
    <message>
        <source>Clients cannot connect</source>
        <translation>Clientes sem ligação</translation>
    </message>
    <message>
        <source>Control: %1, %2 waiting</source>
        <translation>Controlo: %1, %2 à espera</translation>
    </message>
    <message>
        <source>, +%1</source>
        <translation>, +%1</translation>
    </message>
    <message>
        <source>no clients</source>
        <translation>sem clientes</translation>
    </message>
    <message>
        <source>Who has control, and how many clients wait for it. While the operator has control, Boresight refuses motion commands of rotctld clients.</source>
        <translation>Quem pode mover a montagem, e quantos clientes esperam. Enquanto o operador tiver o controlo, os comandos de movimento dos clientes rotctld são recusados.</translation>
    </message>
    <message>
        <source>, in control</source>
        <translation>, move</translation>
    </message>
    <message>
        <source>Target and its source</source>
        <translation>Alvo e quem o deu</translation>
    </message>
    <message>
        <source>Who has control</source>
        <translation>Quem pode mover a montagem</translation>
    </message>
    <message>
        <source>No real drive is connected. Settings and results stay in the simulation of this mount.</source>
        <translation>Nenhum acionamento real está ligado. O que aqui se define e acha fica na simulação desta montagem.</translation>
    </message>
    <message>
        <source>The target is outside the limits. The mount goes to the nearest permitted point.
%1</source>
        <translation>O alvo está fora dos limites. A montagem vai ao ponto permitido mais próximo.
%1</translation>
    </message>
    <message>
        <source>Boresight was started with --simulate. No mount is real until the program ends.</source>
        <translation>O Boresight foi iniciado com --simulate. Nenhuma montagem é real até ao fim do programa.</translation>
    </message>
    <message>
        <source>AT LIMIT</source>
        <translation>NO LIMITE</translation>
    </message>
    <message>
        <source>Tracking %1</source>
        <translation>A seguir %1</translation>
    </message>
    <message>
        <source>Tracking %1, sets in %2</source>
        <translation>A seguir %1, põe-se em %2</translation>
    </message>
    <message>
        <source>Waiting for %1, rises in %2</source>
        <translation>À espera de %1, nasce em %2</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>Schedule armed</source>
        <translation>Agenda armada</translation>
    </message>
    <message>
        <source>Schedule armed: %1 in %2</source>
        <translation>Agenda armada: %1 em %2</translation>
    </message>
    <message>
        <source>Error of the clock</source>
        <translation>Erro do relógio</translation>
    </message>
</context>
<context>
    <name>boresight::ui::HelpPage</name>
    <message>
        <source>Pause, F12</source>
        <translation>Pause, F12</translation>
    </message>
    <message>
        <source>STOP from anywhere</source>
        <translation>STOP de qualquer lugar</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>arrows</source>
        <translation>setas</translation>
    </message>
    <message>
        <source>Shift + arrow</source>
        <translation>Shift + seta</translation>
    </message>
    <message>
        <source>Ctrl + arrow</source>
        <translation>Ctrl + seta</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Ctrl+1 … Ctrl+5</source>
        <translation>Ctrl+1 … Ctrl+5</translation>
    </message>
    <message>
        <source>Ctrl+9</source>
        <translation>Ctrl+9</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Ctrl+0, Ctrl++, Ctrl+-</source>
        <translation>Ctrl+0, Ctrl++, Ctrl+-</translation>
    </message>
    <message>
        <source>F8</source>
        <translation>F8</translation>
    </message>
    <message>
        <source>acknowledge the alarms</source>
        <translation>reconhecer os alarmes</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>full screen</source>
        <translation>ecrã inteiro</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Ctrl+6 … Ctrl+8</source>
        <translation>Ctrl+6 … Ctrl+8</translation>
    </message>
    <message>
        <source>Ctrl+F</source>
        <translation>Ctrl+F</translation>
    </message>
    <message>
        <source>search the settings (in Profile)</source>
        <translation>procurar nos parâmetros (em Perfil)</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>save diagnostics for a bug report</source>
        <translation>gravar diagnóstico para um relato de erro</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page Up, Page Down</translation>
    </message>
    <message>
        <source>gamepad</source>
        <translation>gamepad</translation>
    </message>
    <message>
        <source>F3, Alt+Left, Alt+Right</source>
        <translation>F3, Alt+Esquerda, Alt+Direita</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Move by hand</source>
        <translation>Mover à mão</translation>
    </message>
    <message>
        <source>move at the fast rate</source>
        <translation>mover à velocidade rápida</translation>
    </message>
    <message>
        <source>move one step, or trim the target of a client</source>
        <translation>mover um passo, ou corrigir o alvo de um cliente</translation>
    </message>
    <message>
        <source>Ctrl+H, Ctrl+P</source>
        <translation>Ctrl+H, Ctrl+P</translation>
    </message>
    <message>
        <source>hold the position, park</source>
        <translation>segurar a posição, estacionar</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Painéis</translation>
    </message>
    <message>
        <source>Jog, Charts, Limits, Clients, Log</source>
        <translation>Manual, Gráficos, Limites, Clientes, Registo</translation>
    </message>
    <message>
        <source>Mount: Drives, Protection, Profile</source>
        <translation>Montagem: Acionamentos, Proteção, Perfil</translation>
    </message>
    <message>
        <source>North, or the question about the cable wrap</source>
        <translation>Norte, ou a pergunta sobre a volta do cabo</translation>
    </message>
    <message>
        <source>commissioning guide, its steps</source>
        <translation>guia de instalação, os seus passos</translation>
    </message>
    <message>
        <source>Sky and charts</source>
        <translation>Céu e gráficos</translation>
    </message>
    <message>
        <source>edit the limits on the sky: drag (Shift: 0.1°), + adds, Del removes</source>
        <translation>editar os limites no céu: arrastar (Shift: 0.1°), + acrescenta, Del retira</translation>
    </message>
    <message>
        <source>magnify the sky around the target (also the wheel)</source>
        <translation>ampliar o céu em torno do alvo (também a roda)</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Janela</translation>
    </message>
    <message>
        <source>F10, Alt</source>
        <translation>F10, Alt</translation>
    </message>
    <message>
        <source>open the menu</source>
        <translation>abrir o menu</translation>
    </message>
    <message>
        <source>next theme: day, night, red</source>
        <translation>tema seguinte: dia, noite, vermelho</translation>
    </message>
    <message>
        <source>F1, Shift+F1</source>
        <translation>F1, Shift+F1</translation>
    </message>
    <message>
        <source>manual, this page</source>
        <translation>manual, esta página</translation>
    </message>
    <message>
        <source>STOP is a function of this program: the mount slows down and holds its position.
It does not replace the hard-wired emergency stop beside the mast.</source>
        <translation>STOP é uma função deste programa: a montagem abranda e segura a posição.
Não substitui a paragem de emergência por cabo junto ao mastro.</translation>
    </message>
    <message>
        <source>change the jog rate (on the slider, also with arrows, Home, End)</source>
        <translation>mudar a velocidade manual (no cursor, também com setas, Home, End)</translation>
    </message>
    <message>
        <source>hold LB or RB and move the left stick. B is STOP</source>
        <translation>segurar LB ou RB e mover a alavanca esquerda. B é STOP</translation>
    </message>
    <message>
        <source>go to the Az field. Enter starts the move</source>
        <translation>ir ao campo Az. Enter inicia o movimento</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Passagens</translation>
    </message>
    <message>
        <source>move while held. First arm the pad (click it, or press Enter)</source>
        <translation>mover enquanto premida. Arme primeiro o painel (clique nele ou prima Enter)</translation>
    </message>
    <message>
        <source>leave a field, list, menu, card or question. The next Esc is STOP</source>
        <translation>sair de um campo, lista, menu, cartão ou pergunta. O Esc seguinte é STOP</translation>
    </message>
</context>
<context>
    <name>boresight::ui::HistoryModel</name>
    <message>
        <source>Applied</source>
        <translation>Aplicada</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>%1 (undone)</source>
        <translation>%1 (desfeita)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::HistoryPage</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>None of these is in force</source>
        <translation>Nenhuma destas está em vigor</translation>
    </message>
    <message>
        <source>In force: %1</source>
        <translation>Em vigor: %1</translation>
    </message>
    <message>
        <source>Calibrations that were applied</source>
        <translation>Calibrações aplicadas</translation>
    </message>
    <message>
        <source>Calibration in force</source>
        <translation>Calibração em vigor</translation>
    </message>
    <message>
        <source>The selected calibration</source>
        <translation>A calibração selecionada</translation>
    </message>
    <message>
        <source>Select a line to read it whole</source>
        <translation>Selecione uma linha para a ler inteira</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Refazer</translation>
    </message>
    <message>
        <source>Redo the calibration</source>
        <translation>Refazer a calibração</translation>
    </message>
    <message>
        <source>Undone, and another calibration was applied later. Kept for reading only</source>
        <translation>Anulada, e outra calibração foi aplicada depois. Guardada só para leitura</translation>
    </message>
    <message>
        <source>▲ %1: may not be valid here</source>
        <translation>▲ %1: pode não valer aqui</translation>
    </message>
    <message>
        <source>No calibration was applied to this mount yet</source>
        <translation>Ainda nada foi aplicado a esta montagem</translation>
    </message>
    <message>
        <source>The calibration in force is from other drives or another site. Check it</source>
        <translation>A calibração em vigor é de outros acionamentos ou de outro local. Verifique-a</translation>
    </message>
    <message>
        <source>Apply the undone calibration again. Nothing moves</source>
        <translation>Aplica de novo a calibração anulada. Nada se move</translation>
    </message>
</context>
<context>
    <name>boresight::ui::HoldButtons</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>AZ ↺ hold</source>
        <translation>AZ ↺ segurar</translation>
    </message>
    <message>
        <source>AZ ↻ hold</source>
        <translation>AZ ↻ segurar</translation>
    </message>
    <message>
        <source>EL ↓ hold</source>
        <translation>EL ↓ segurar</translation>
    </message>
    <message>
        <source>EL ↑ hold</source>
        <translation>EL ↑ segurar</translation>
    </message>
</context>
<context>
    <name>boresight::ui::HorizonModel</name>
    <message>
        <source>There is already a point at this azimuth.</source>
        <translation>Já existe um ponto neste azimute.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::JogButton</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>requested</source>
        <translation>pedido</translation>
    </message>
</context>
<context>
    <name>boresight::ui::JogChoices</name>
    <message>
        <source>Rate while held</source>
        <translation>Velocidade enquanto premido</translation>
    </message>
    <message>
        <source>Jog rate</source>
        <translation>Velocidade manual</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>One step is %1 (Ctrl + arrow)</source>
        <translation>Um passo é %1 (Ctrl + seta)</translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation>Modo de passos</translation>
    </message>
    <message>
        <source>Step mode: a press moves one step only</source>
        <translation>Modo de passos: cada clique move só um passo</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>no máximo %1</translation>
    </message>
    <message>
        <source>Jog rate from %1 to %2 (arrow keys, Page Up, Page Down). Shift + arrow on the pad jogs at the fast rate.</source>
        <translation>Velocidade manual de %1 a %2 (setas, Page Up, Page Down). Shift + seta no painel move à velocidade rápida.</translation>
    </message>
    <message>
        <source>The rate is at most %1 until the cable wraps are known and the directions are confirmed.</source>
        <translation>A velocidade é no máximo %1 até se conhecerem as voltas do cabo e os sentidos estarem confirmados.</translation>
    </message>
    <message>
        <source>This rotator moves in steps of %1°.</source>
        <translation>Este rotor move-se em passos de %1°.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::JogPad</name>
    <message>
        <source>Elevation up while held</source>
        <translation>Elevação sobe enquanto premido</translation>
    </message>
    <message>
        <source>Elevation down while held</source>
        <translation>Elevação desce enquanto premido</translation>
    </message>
    <message>
        <source>Azimuth counter-clockwise while held</source>
        <translation>Azimute anti-horário enquanto premido</translation>
    </message>
    <message>
        <source>Azimuth clockwise while held</source>
        <translation>Azimute horário enquanto premido</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Manter</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Setas do teclado</translation>
    </message>
    <message>
        <source>Jog pad</source>
        <translation>Campo de movimento manual</translation>
    </message>
    <message>
        <source>Step: %1</source>
        <translation>Passo: %1</translation>
    </message>
    <message>
        <source>Jog: %1</source>
        <translation>Manual: %1</translation>
    </message>
    <message>
        <source>Click here to arm the arrow keys</source>
        <translation>Clique aqui para armar as setas</translation>
    </message>
    <message>
        <source>ARMED: an arrow key moves one step</source>
        <translation>ARMADO: cada seta move um passo</translation>
    </message>
    <message>
        <source>Stop the motion and hold the position (Ctrl+H)</source>
        <translation>Parar o movimento e segurar a posição (Ctrl+H)</translation>
    </message>
    <message>
        <source>Press Enter to arm the arrow keys. An armed arrow key moves the mount while it is held.</source>
        <translation>Prima Enter para armar as setas. Uma seta armada move a montagem enquanto estiver premida.</translation>
    </message>
    <message>
        <source>ARMED: hold an arrow key to move</source>
        <translation>ARMADO: segure uma seta para mover</translation>
    </message>
    <message>
        <source>A step trims the target (Ctrl + arrow)</source>
        <translation>Um passo corrige (Ctrl + seta)</translation>
    </message>
    <message>
        <source>Click to arm the arrow keys, or hold LB or RB</source>
        <translation>Clique para armar as setas, ou segure LB ou RB</translation>
    </message>
    <message>
        <source>%1: hold LB or RB and move the left stick to jog. Button B is STOP.</source>
        <translation>%1: segure LB ou RB e mova a alavanca esquerda. O botão B é STOP.</translation>
    </message>
    <message>
        <source>Elevation up by %1</source>
        <translation>Elevação sobe %1</translation>
    </message>
    <message>
        <source>Elevation down by %1</source>
        <translation>Elevação desce %1</translation>
    </message>
    <message>
        <source>Azimuth counter-clockwise by %1</source>
        <translation>Azimute roda %1 no sentido anti-horário</translation>
    </message>
    <message>
        <source>Azimuth clockwise by %1</source>
        <translation>Azimute roda %1 no sentido horário</translation>
    </message>
</context>
<context>
    <name>boresight::ui::JogPanel</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Clear trim</source>
        <translation>Limpar comp.</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Correção</translation>
    </message>
    <message>
        <source>Move by hand</source>
        <translation>Mover à mão</translation>
    </message>
    <message>
        <source>Trim: AZ %1 EL %2</source>
        <translation>Correção: AZ %1 EL %2</translation>
    </message>
    <message>
        <source>No trim</source>
        <translation>Sem correção</translation>
    </message>
    <message>
        <source>%1. Your steps are added to the targets of the clients.</source>
        <translation>%1. Os seus passos somam-se aos alvos dos clientes.</translation>
    </message>
    <message>
        <source>Trim: X %1 Y %2</source>
        <translation>Correção: X %1 Y %2</translation>
    </message>
    <message>
        <source>X %1
Y %2</source>
        <translation>X %1
Y %2</translation>
    </message>
    <message>
        <source>AZ %1
EL %2</source>
        <translation>AZ %1
EL %2</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LandmarkBox</name>
    <message>
        <source>True azimuth of the landmark</source>
        <translation>Azimute verdadeiro do marco</translation>
    </message>
    <message>
        <source>True elevation of the landmark</source>
        <translation>Elevação verdadeira do marco</translation>
    </message>
    <message>
        <source>0° is level</source>
        <translation>0° é o nível</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Marco</translation>
    </message>
    <message>
        <source>Take point</source>
        <translation>Tomar ponto</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nome</translation>
    </message>
    <message>
        <source>Name of the landmark</source>
        <translation>Nome do marco</translation>
    </message>
    <message>
        <source>Az</source>
        <translation>Az</translation>
    </message>
    <message>
        <source>El</source>
        <translation>El</translation>
    </message>
    <message>
        <source>points taken: %1</source>
        <translation>pontos tomados: %1</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Agora não: %1</translation>
    </message>
    <message>
        <source>From true north, by a map or a GPS receiver</source>
        <translation>A partir do norte verdadeiro, como o diz um mapa ou um recetor GPS</translation>
    </message>
    <message>
        <source>The target is centred now. Store the position of the axes</source>
        <translation>O alvo está centrado agora. Guarda a posição dos eixos</translation>
    </message>
    <message>
        <source>Type the direction of the landmark first. For 0 and 0 type its name, too.</source>
        <translation>Escreva primeiro a direção do marco. Para 0 e 0 escreva também o nome.</translation>
    </message>
    <message>
        <source>Store the landmark as a point</source>
        <translation>Guardar a referência como ponto</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LevelBar</name>
    <message>
        <source>%1 of 3</source>
        <translation>%1 de 3</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>não comunicado</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LimitRow</name>
    <message>
        <source>Lowest %1</source>
        <translation>Limite inferior de %1</translation>
    </message>
    <message>
        <source>Highest %1</source>
        <translation>Limite superior de %1</translation>
    </message>
    <message>
        <source>%1, within the travel %2…%3</source>
        <translation>%1, dentro do curso %2…%3</translation>
    </message>
    <message>
        <source>Travel of the %1. Hatched: outside the limits. Pointer: present position</source>
        <translation>Curso de %1. Tracejado: fora dos limites. Ponteiro: posição atual</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LimitsPanel</name>
    <message>
        <source>Horizon</source>
        <translation>Horizonte</translation>
    </message>
    <message>
        <source>Keep-outs</source>
        <translation>Zonas proibidas</translation>
    </message>
    <message>
        <source>%1: type into a cell, or drag on the plot (Edit, Ctrl+E)</source>
        <translation>%1: escreva numa célula, ou arraste no gráfico (Editar, Ctrl+E)</translation>
    </message>
    <message>
        <source>Add a point of the horizon</source>
        <translation>Acrescentar um ponto do horizonte</translation>
    </message>
    <message>
        <source>Remove the current point of the horizon (Del)</source>
        <translation>Retirar o ponto atual do horizonte (Del)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fich.</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importar …</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportar …</translation>
    </message>
    <message>
        <source>Add keep-out</source>
        <translation>Nova zona proibida</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Remove the current keep-out (Del)</source>
        <translation>Retirar a zona proibida atual (Del)</translation>
    </message>
    <message>
        <source>Keep-outs, clockwise from … to</source>
        <translation>Zonas proibidas, no sentido horário de … a</translation>
    </message>
    <message>
        <source>Import a horizon</source>
        <translation>Importar um horizonte</translation>
    </message>
    <message>
        <source>Horizon (*.txt *.hrz *.hzn *.csv)</source>
        <translation>Horizonte (*.txt *.hrz *.hzn *.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Export the horizon</source>
        <translation>Exportar o horizonte</translation>
    </message>
    <message>
        <source>Horizon (*.txt)</source>
        <translation>Horizonte (*.txt)</translation>
    </message>
    <message>
        <source>written</source>
        <translation>gravado</translation>
    </message>
    <message>
        <source>Why the entry was refused</source>
        <translation>Por que o texto não foi aceito</translation>
    </message>
    <message>
        <source>Import or export the horizon (az el)</source>
        <translation>Importar ou exportar o horizonte (az el)</translation>
    </message>
    <message>
        <source>Select a row first.</source>
        <translation>Selecione primeiro uma linha.</translation>
    </message>
    <message>
        <source>Add a keep-out around the present direction of the mount</source>
        <translation>Acrescentar uma zona proibida em torno da direção atual da montagem</translation>
    </message>
    <message>
        <source>The horizon has no point.</source>
        <translation>O horizonte não tem nenhum ponto.</translation>
    </message>
    <message>
        <source>There is no keep-out.</source>
        <translation>Não há nenhuma zona proibida.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LinesView</name>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Selected line</source>
        <translation>Linha selecionada</translation>
    </message>
    <message>
        <source>File …</source>
        <translation>Ficheiro …</translation>
    </message>
    <message>
        <source>Save the lines</source>
        <translation>Gravar as linhas</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texto (*.txt)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Lines written: %1</source>
        <translation>Linhas gravadas: %1</translation>
    </message>
    <message>
        <source>Not written: %1</source>
        <translation>Não gravado: %1</translation>
    </message>
    <message>
        <source>Select a line to read all of it</source>
        <translation>Escolha uma linha para a ler toda</translation>
    </message>
    <message>
        <source>Copy the selected lines, or all lines (Ctrl+C in the list)</source>
        <translation>Copiar as linhas escolhidas, ou todas (Ctrl+C na lista)</translation>
    </message>
    <message>
        <source>Save all lines of the list to a text file</source>
        <translation>Gravar todas as linhas da lista num ficheiro de texto</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LockPrompt</name>
    <message>
        <source>%1 is tracking %2. Track it from Boresight&apos;s own orbit?</source>
        <translation>%1 segue %2. Segui-lo pela órbita do próprio Boresight?</translation>
    </message>
    <message>
        <source>A client</source>
        <translation>Um cliente</translation>
    </message>
    <message>
        <source>Boresight knows the target of a client</source>
        <translation>O Boresight conhece o alvo de um cliente</translation>
    </message>
    <message>
        <source>Track it</source>
        <translation>Segui-lo</translation>
    </message>
    <message>
        <source>Boresight computes the target itself, so the beam stays on it. The client keeps control</source>
        <translation>O próprio Boresight calcula o alvo, por isso o feixe fica nele. O cliente mantém o controlo</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Agora não</translation>
    </message>
    <message>
        <source>The points of the client move the mount. Boresight does not ask again about this target</source>
        <translation>Os pontos do cliente movem a montagem. O Boresight não volta a perguntar por este alvo</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LogModel</name>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origem</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LogPage</name>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Why did it move?</source>
        <translation>Por que se moveu?</translation>
    </message>
    <message>
        <source>Filter by source</source>
        <translation>Filtrar por origem</translation>
    </message>
    <message>
        <source>All sources</source>
        <translation>Todas as origens</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operador</translation>
    </message>
    <message>
        <source>rotctld clients</source>
        <translation>Clientes rotctld</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Estação</translation>
    </message>
    <message>
        <source>▲ only</source>
        <translation>só ▲</translation>
    </message>
    <message>
        <source>Warnings and alarms only</source>
        <translation>Só avisos e alarmes</translation>
    </message>
    <message>
        <source>Filter by text</source>
        <translation>Filtrar por texto</translation>
    </message>
    <message>
        <source>contains</source>
        <translation>contém</translation>
    </message>
</context>
<context>
    <name>boresight::ui::LogPanel</name>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Why did it move?</source>
        <translation>Por que se moveu?</translation>
    </message>
    <message>
        <source>Who moved the mount, and why</source>
        <translation>Quem moveu a montagem, e por quê</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Every line of the log</source>
        <translation>Todas as linhas do registo</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>Alarmes (%1)</translation>
    </message>
    <message>
        <source>Bundle …</source>
        <translation>Pacote …</translation>
    </message>
    <message>
        <source>Save diagnostics …</source>
        <translation>Gravar diagnóstico …</translation>
    </message>
    <message>
        <source>Save diagnostics for a bug report: profile, logs, drives, the last minutes (Ctrl+B)</source>
        <translation>Gravar diagnóstico para um relato de erro: perfil, registos, acionamentos, os últimos minutos (Ctrl+B)</translation>
    </message>
    <message>
        <source>Control ticks: 99 % are late by at most %1 ms, the worst by %2 ms. %3</source>
        <translation>Ciclos de controlo: 99 % atrasam no máximo %1 ms, o pior %2 ms. %3</translation>
    </message>
    <message>
        <source>Active alarms, and all alarms since the start of the window</source>
        <translation>Alarmes de agora e desde o início da janela</translation>
    </message>
</context>
<context>
    <name>boresight::ui::MainMenu</name>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Ecrã inteiro</translation>
    </message>
    <message>
        <source>Commissioning guide</source>
        <translation>Guia de instalação</translation>
    </message>
    <message>
        <source>Open profile</source>
        <translation>Abrir perfil</translation>
    </message>
    <message>
        <source>Read the manual</source>
        <translation>Ler o manual</translation>
    </message>
    <message>
        <source>Show keys</source>
        <translation>Mostrar teclas</translation>
    </message>
    <message>
        <source>Save diagnostics …</source>
        <translation>Gravar diagnóstico …</translation>
    </message>
    <message>
        <source>About Boresight</source>
        <translation>Acerca do Boresight</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Brilho</translation>
    </message>
    <message>
        <source>The brightness of the night and the red theme</source>
        <translation>O brilho dos temas noite e vermelho</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>Changes at the next start</source>
        <translation>Muda no próximo arranque</translation>
    </message>
    <message>
        <source>Open recording …</source>
        <translation>Abrir gravação …</translation>
    </message>
</context>
<context>
    <name>boresight::ui::MainWindow</name>
    <message>
        <source>Last line of the log</source>
        <translation>Última linha do registo</translation>
    </message>
    <message>
        <source>Boresight</source>
        <translation>Boresight</translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation>STOP: %1</translation>
    </message>
    <message>
        <source>Diagnostics saved: %1</source>
        <translation>Diagnóstico gravado: %1</translation>
    </message>
    <message>
        <source>Diagnostics not saved: %1</source>
        <translation>Diagnóstico não gravado: %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ManualWindow</name>
    <message>
        <source>Boresight manual</source>
        <translation>Manual do Boresight</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Procurar no manual</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Índice</translation>
    </message>
    <message>
        <source>Text of the manual</source>
        <translation>Texto do manual</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>Procurar seguinte</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Voltar</translation>
    </message>
    <message>
        <source>Not in this page</source>
        <translation>Não está nesta página</translation>
    </message>
    <message>
        <source>Go back to the previous page</source>
        <translation>Voltar à página anterior</translation>
    </message>
</context>
<context>
    <name>boresight::ui::MeasurePage</name>
    <message>
        <source>Torque</source>
        <translation>Torque</translation>
    </message>
    <message>
        <source>Show the torque in place of the tracking error</source>
        <translation>Mostrar o torque em vez do erro de seguimento</translation>
    </message>
    <message>
        <source>First tuning</source>
        <translation>Primeira afinação</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Seguinte</translation>
    </message>
    <message>
        <source>The next step of the first tuning</source>
        <translation>O passo seguinte da primeira afinação</translation>
    </message>
    <message>
        <source>Measure …</source>
        <translation>Medir …</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>End run</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>End the run. The mount holds</source>
        <translation>Terminar a medição. A montagem fica parada</translation>
    </message>
    <message>
        <source>Read gains</source>
        <translation>Ler ganhos</translation>
    </message>
    <message>
        <source>Read the gains of this drive. Nothing moves</source>
        <translation>Ler os ganhos deste acionamento. Nada se move</translation>
    </message>
    <message>
        <source>Next …</source>
        <translation>Seguinte …</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Ganhos</translation>
    </message>
    <message>
        <source>Show the gains of this drive</source>
        <translation>Mostrar os ganhos deste acionamento</translation>
    </message>
    <message>
        <source>Move the %1?</source>
        <translation>Mover o %1?</translation>
    </message>
    <message>
        <source>Move the axis</source>
        <translation>Mover o eixo</translation>
    </message>
    <message>
        <source>The run or its result</source>
        <translation>A medição ou o seu resultado</translation>
    </message>
    <message>
        <source>Move the axis through this run. Asks first</source>
        <translation>Mover o eixo nesta medição. Pergunta primeiro</translation>
    </message>
    <message>
        <source>%1 of the %2: %3 % done, %4 left. STOP or any other command ends it.</source>
        <translation>%1 do %2: %3 % feito, faltam %4. STOP ou qualquer outro comando termina-a.</translation>
    </message>
    <message>
        <source>%1

Keep people and ropes clear of the antenna. STOP or any other command ends the run.</source>
        <translation>%1

Mantenha pessoas e cordas longe da antena. STOP ou qualquer outro comando termina a medição.</translation>
    </message>
    <message>
        <source>Moves 2° away and back. Shows overshoot and settling time</source>
        <translation>Move 2° para lá e para cá. Mostra a ultrapassagem e o tempo até estabilizar</translation>
    </message>
    <message>
        <source>Moves away and back at 0.5 °/s. Shows the tracking error of a pass</source>
        <translation>Move para lá e para cá a 0,5 °/s. Mostra o erro de seguimento de uma passagem</translation>
    </message>
    <message>
        <source>Moves very slowly to and fro. Finds the backlash of the gear by the torque</source>
        <translation>Move muito devagar para lá e para cá. Encontra a folga da engrenagem pelo binário</translation>
    </message>
    <message>
        <source>Swings a little at four frequencies. Shows the highest frequency that the axis follows</source>
        <translation>Oscila um pouco a quatro frequências. Mostra a frequência mais alta que o eixo segue</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ModelChoice</name>
    <message>
        <source>Model of the rotator</source>
        <translation>Modelo do rotor</translation>
    </message>
    <message>
        <source>Type a part of its name, its maker or its number</source>
        <translation>Escreva parte do nome, do fabricante ou do número</translation>
    </message>
    <message>
        <source>Model: type a part of its name</source>
        <translation>Modelo: escreva parte do nome</translation>
    </message>
    <message>
        <source>Choose the model of the rotator.</source>
        <translation>Escolha o modelo do rotor.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ModelPage</name>
    <message>
        <source>How well the model fits</source>
        <translation>Como o modelo se ajusta</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Terms of the pointing model</source>
        <translation>Termos do modelo de apontamento</translation>
    </message>
    <message>
        <source>Calibration points</source>
        <translation>Pontos de calibração</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Apagar</translation>
    </message>
    <message>
        <source>Drop the selected point</source>
        <translation>Apagar o ponto selecionado</translation>
    </message>
    <message>
        <source>Terms</source>
        <translation>Termos</translation>
    </message>
    <message>
        <source>The terms of the pointing model</source>
        <translation>Os termos do modelo de apontamento</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Remarks on the fit</source>
        <translation>Notas do ajuste</translation>
    </message>
    <message>
        <source>Use again</source>
        <translation>Usar</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Digitar</translation>
    </message>
    <message>
        <source>Type the terms, or exchange them with a file</source>
        <translation>Digitar os termos, ou trocá-los com um ficheiro</translation>
    </message>
    <message>
        <source>Delete the selected point</source>
        <translation>Esquece de vez o ponto selecionado</translation>
    </message>
    <message>
        <source>Select a point first.</source>
        <translation>Selecione primeiro um ponto.</translation>
    </message>
    <message>
        <source>1 point finds the azimuth offset. 2 points also find the elevation offset. With 3 points or more the fit finds other terms.</source>
        <translation>1 ponto acha o desvio de azimute. 2 pontos acham também o desvio de elevação. Com 3 pontos ou mais o ajuste acha outros termos.</translation>
    </message>
    <message>
        <source>Leave the selected point out of the fit. It stays in the list</source>
        <translation>Deixar o ponto selecionado fora do ajuste. Fica na lista</translation>
    </message>
    <message>
        <source>Use the selected point in the fit again</source>
        <translation>Voltar a usar o ponto selecionado no ajuste</translation>
    </message>
    <message>
        <source>Here the sensor measures the azimuth to %1 (1 sigma). It cannot check a more exact model</source>
        <translation>Aqui o sensor mede o azimute com %1 (1 sigma). Não pode verificar um modelo mais exato</translation>
    </message>
    <message>
        <source>The points and their residuals</source>
        <translation>Os pontos e os seus resíduos</translation>
    </message>
</context>
<context>
    <name>boresight::ui::MomentNumbers</name>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>real</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>comandado</translation>
    </message>
    <message>
        <source>target</source>
        <translation>alvo</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>binário</translation>
    </message>
    <message>
        <source>Actual %1</source>
        <translation>%1 real</translation>
    </message>
    <message>
        <source>Commanded %1</source>
        <translation>%1 comandado</translation>
    </message>
    <message>
        <source>Target %1</source>
        <translation>%1 do alvo</translation>
    </message>
    <message>
        <source>Torque of %1</source>
        <translation>Binário de %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erro</translation>
    </message>
    <message>
        <source>Error on the sky</source>
        <translation>Erro no céu</translation>
    </message>
</context>
<context>
    <name>boresight::ui::NearestOffer</name>
    <message>
        <source>Go there</source>
        <translation>Ir para lá</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Ir para %1</translation>
    </message>
    <message>
        <source>Go to %1, the nearest allowed direction</source>
        <translation>Ir para %1, a direção permitida mais próxima</translation>
    </message>
</context>
<context>
    <name>boresight::ui::NoteLine</name>
    <message>
        <source>Note about the satellite</source>
        <translation>Nota sobre o satélite</translation>
    </message>
    <message>
        <source>Note: frequency, polarisation, …</source>
        <translation>Nota: frequência, polarização, …</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Nota: %1</translation>
    </message>
    <message>
        <source>A note about this satellite. Enter stores the note. Esc restores the old note</source>
        <translation>Uma nota sobre este satélite. Enter guarda a nota. Esc repõe a nota anterior</translation>
    </message>
</context>
<context>
    <name>boresight::ui::OffButton</name>
    <message>
        <source>Error budget</source>
        <translation>Balanço de erros</translation>
    </message>
    <message>
        <source>Show the error budget</source>
        <translation>Mostrar o balanço de erros</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PanelTabs</name>
    <message>
        <source>Panels</source>
        <translation>Painéis</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Jog panel (Ctrl+1)</source>
        <translation>Painel de movimento manual (Ctrl+1)</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Limits, horizon and keep-outs (Ctrl+3)</source>
        <translation>Limites, horizonte e zonas proibidas (Ctrl+3)</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Clientes</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registo</translation>
    </message>
    <message>
        <source>Log panel (Ctrl+5)</source>
        <translation>Painel do registo (Ctrl+5)</translation>
    </message>
    <message>
        <source>Mount</source>
        <translation>Montagem</translation>
    </message>
    <message>
        <source>The mount itself</source>
        <translation>A própria montagem</translation>
    </message>
    <message>
        <source>Drives</source>
        <translation>Acionamentos</translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Proteções</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>North</source>
        <translation>Norte</translation>
    </message>
    <message>
        <source>Finding north: sensor, swing, Sun and Moon (Ctrl+9)</source>
        <translation>Achar o norte: sensor, giro, Sol e Lua (Ctrl+9)</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Leituras</translation>
    </message>
    <message>
        <source>What the drives report now</source>
        <translation>O que os acionamentos comunicam agora</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Afinação</translation>
    </message>
    <message>
        <source>Measure the axes and tune the gains of the drives</source>
        <translation>Quão bem os eixos são controlados, e os ganhos</translation>
    </message>
    <message>
        <source>Position, error and drive over time (Ctrl+2)</source>
        <translation>Posição, erro e acionamento ao longo do tempo (Ctrl+2)</translation>
    </message>
    <message>
        <source>rotctld clients, and which of them has control (Ctrl+4)</source>
        <translation>Clientes rotctld, e qual deles tem o controlo (Ctrl+4)</translation>
    </message>
    <message>
        <source>▲ Wrap?</source>
        <translation>▲ Volta?</translation>
    </message>
    <message>
        <source>Where is the axis now? (Ctrl+9)</source>
        <translation>Em que volta está o eixo? (Ctrl+9)</translation>
    </message>
    <message>
        <source>Drives, bus and crash-stop test (Ctrl+6)</source>
        <translation>Acionamentos, barramento e ensaio de parada brusca (Ctrl+6)</translation>
    </message>
    <message>
        <source>Safety settings of the drives (Ctrl+7)</source>
        <translation>As proteções dos próprios acionamentos (Ctrl+7)</translation>
    </message>
    <message>
        <source>All settings, and the stored mounts (Ctrl+8)</source>
        <translation>Todos os parâmetros, e as montagens guardadas (Ctrl+8)</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Passagens</translation>
    </message>
    <message>
        <source>Coming passes of satellites (Ctrl+T)</source>
        <translation>Próximas passagens de satélites (Ctrl+T)</translation>
    </message>
    <message>
        <source>Passes of satellites</source>
        <translation>Passagens de satélites</translation>
    </message>
    <message>
        <source>Coming</source>
        <translation>Próximas</translation>
    </message>
    <message>
        <source>Schedule</source>
        <translation>Agenda</translation>
    </message>
    <message>
        <source>The passes that the mount tracks by itself</source>
        <translation>As passagens que a montagem segue sozinha</translation>
    </message>
    <message>
        <source>Moon, Sun, others</source>
        <translation>Lua e outros</translation>
    </message>
    <message>
        <source>Targets other than satellites</source>
        <translation>Alvos que não são satélites</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Consola</translation>
    </message>
    <message>
        <source>Type a line to the control box, or make a home run</source>
        <translation>Digitar uma linha para a caixa de controlo, ou procurar a referência</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassColumns</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Columns of the list</source>
        <translation>Colunas da lista</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>As many columns as fit</source>
        <translation>Tantas colunas quantas caibam</translation>
    </message>
    <message>
        <source>Columns of the list of passes</source>
        <translation>Colunas da lista de passagens</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassCurve</name>
    <message>
        <source>Elevation over time</source>
        <translation>Elevação ao longo do tempo</translation>
    </message>
    <message>
        <source>From %1Z to %2Z, %3 high at %4Z</source>
        <translation>Das %1Z às %2Z, %3 de altura às %4Z</translation>
    </message>
    <message>
        <source>Select a pass first.</source>
        <translation>Escolha primeiro uma passagem.</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>desde %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassFilter</name>
    <message>
        <source>Favourites only</source>
        <translation>Só favoritos</translation>
    </message>
    <message>
        <source>Satellites to list</source>
        <translation>Satélites a listar</translation>
    </message>
    <message>
        <source>Name or number</source>
        <translation>Nome ou número</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>pelo menos</translation>
    </message>
    <message>
        <source>Passes that stay lower are not listed</source>
        <translation>As passagens que ficam mais baixas não são listadas</translation>
    </message>
    <message>
        <source>Elevation that a listed pass must reach</source>
        <translation>Elevação que uma passagem da lista tem de atingir</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassPlanner</name>
    <message>
        <source>The mount reaches no part of this pass.</source>
        <translation>A montagem não alcança nenhuma parte desta passagem.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassTable</name>
    <message>
        <source>Satellite</source>
        <translation>Satélite</translation>
    </message>
    <message>
        <source>Rises (UTC)</source>
        <translation>Nasce (UTC)</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Em</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Dura</translation>
    </message>
    <message>
        <source>always</source>
        <translation>sempre</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorito</translation>
    </message>
    <message>
        <source>No favourite</source>
        <translation>Não é favorito</translation>
    </message>
    <message>
        <source>A click makes this satellite a favourite</source>
        <translation>Um clique torna este satélite favorito</translation>
    </message>
    <message>
        <source>A favourite. A click removes the star</source>
        <translation>Um favorito. Um clique retira a estrela</translation>
    </message>
    <message>
        <source>Highest at</source>
        <translation>Máximo às</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Põe-se</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Oculta</translation>
    </message>
    <message>
        <source>Unwraps</source>
        <translation>Desenrola</translation>
    </message>
    <message>
        <source>Sunlit</source>
        <translation>Ao sol</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementos</translation>
    </message>
    <message>
        <source>the highest elevation of the pass</source>
        <translation>a elevação mais alta da passagem</translation>
    </message>
    <message>
        <source>AOS: the satellite rises above the horizon, without refraction</source>
        <translation>AOS: o satélite nasce acima do horizonte, sem refração</translation>
    </message>
    <message>
        <source>time until the satellite rises</source>
        <translation>tempo até o satélite nascer</translation>
    </message>
    <message>
        <source>TCA: the satellite is highest</source>
        <translation>TCA: o satélite está no ponto mais alto</translation>
    </message>
    <message>
        <source>LOS: the satellite sets, without refraction</source>
        <translation>LOS: o satélite põe-se, sem refração</translation>
    </message>
    <message>
        <source>time from rise to set</source>
        <translation>tempo desde nascer até se pôr</translation>
    </message>
    <message>
        <source>how long horizon, keep-outs and limits hide the satellite</source>
        <translation>durante quanto tempo o horizonte, as zonas proibidas e os limites escondem o satélite</translation>
    </message>
    <message>
        <source>whether the cable ends during the pass, and how much of the pass is lost</source>
        <translation>se o cabo acaba durante a passagem, e quanto da passagem se perde</translation>
    </message>
    <message>
        <source>how long the satellite is in sunlight</source>
        <translation>durante quanto tempo o satélite está ao sol</translation>
    </message>
    <message>
        <source>age of the elements in days</source>
        <translation>idade dos elementos em dias</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassTimeline</name>
    <message>
        <source>Timeline of the coming passes</source>
        <translation>Linha do tempo das próximas passagens</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>A high pass has a high bar. Underlined: the schedule tracks it. Hollow: the schedule leaves it out.</source>
        <translation>Uma passagem alta tem uma barra alta. Sublinhada: a agenda segue-a. Oca: a agenda deixa-a de fora.</translation>
    </message>
    <message>
        <source>%1: %2Z to %3Z, %4 high</source>
        <translation>%1: das %2Z às %3Z, %4 de altura</translation>
    </message>
    <message>
        <source>%1 satellites. %2</source>
        <translation>%1 satélites. %2</translation>
    </message>
    <message>
        <source>%1 more satellites are only in the list.</source>
        <translation>Mais %1 satélites estão apenas na lista.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassViews</name>
    <message>
        <source>List</source>
        <translation>Lista</translation>
    </message>
    <message>
        <source>The passes as a list</source>
        <translation>As passagens em lista</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>The passes of the next 24 hours side by side</source>
        <translation>As passagens das próximas 24 horas lado a lado</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevação</translation>
    </message>
    <message>
        <source>The elevation of the selected pass over time</source>
        <translation>A elevação da passagem selecionada ao longo do tempo</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>The path of the selected satellite over the Earth</source>
        <translation>O caminho do satélite selecionado sobre a Terra</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>How the mount will track the selected pass</source>
        <translation>Como a montagem seguirá a passagem selecionada</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PassesPanel</name>
    <message>
        <source>Coming passes</source>
        <translation>Próximas passagens</translation>
    </message>
    <message>
        <source>About the passes</source>
        <translation>Sobre as passagens</translation>
    </message>
    <message>
        <source>Searching for passes: %1 %</source>
        <translation>A procurar passagens: %1 %</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>elementos</translation>
    </message>
    <message>
        <source>%1 passes of %2 satellites within a day</source>
        <translation>%1 passagens de %2 satélites num dia</translation>
    </message>
    <message>
        <source>Problems with the elements</source>
        <translation>Problemas com os elementos</translation>
    </message>
    <message>
        <source>The log has more problems.</source>
        <translation>O registo tem mais problemas.</translation>
    </message>
    <message>
        <source>Favourite, or not</source>
        <translation>Favorito ou não</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>Editar a nota</translation>
    </message>
    <message>
        <source>No favourite passes within a day. Click the star of a row to add one.</source>
        <translation>Nenhum favorito passa dentro de um dia. Clique na estrela de uma linha para juntar um.</translation>
    </message>
    <message>
        <source>Boresight knows no satellites. Add their elements.</source>
        <translation>O Boresight não conhece satélites. Adicione os elementos deles.</translation>
    </message>
    <message>
        <source>The site is not set. Passes depend on it.</source>
        <translation>O local não está definido. As passagens dependem dele.</translation>
    </message>
    <message>
        <source>%1 of %2 passes within a day, of %3 satellites</source>
        <translation>%1 de %2 passagens num dia, de %3 satélites</translation>
    </message>
    <message>
        <source>No satellite rises within a day.</source>
        <translation>Nenhum satélite nasce dentro de um dia.</translation>
    </message>
    <message>
        <source>No pass matches the filter. The filter leaves out %1.</source>
        <translation>Nenhuma passagem corresponde ao filtro. O filtro deixa de fora %1.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PickPrompt</name>
    <message>
        <source>Direction under the cursor</source>
        <translation>Direção sob o cursor</translation>
    </message>
    <message>
        <source>Go here</source>
        <translation>Ir para aqui</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Dispensar</translation>
    </message>
    <message>
        <source>Go to this direction by the shortest way</source>
        <translation>Ir a esta direção pela volta mais próxima</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlacesBar</name>
    <message>
        <source>Refused direction</source>
        <translation>Direção recusada</translation>
    </message>
    <message>
        <source>Park</source>
        <translation>Estacionar</translation>
    </message>
    <message>
        <source>Presets ▾</source>
        <translation>Predefinições ▾</translation>
    </message>
    <message>
        <source>Presets, home, horizon, unwrap</source>
        <translation>Predefinições, início, horizonte, desenrolar</translation>
    </message>
    <message>
        <source>Show or hide the presets, Home, Horizon and Unwrap</source>
        <translation>Mostrar ou ocultar as predefinições, Início, Horizonte e Desenrolar</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Origem</translation>
    </message>
    <message>
        <source>Go to azimuth 0° and the lowest elevation</source>
        <translation>Ir ao azimute 0° e à menor elevação</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>Horizonte</translation>
    </message>
    <message>
        <source>Unwrap</source>
        <translation>Desenrolar</translation>
    </message>
    <message>
        <source>Unpark</source>
        <translation>Liberar</translation>
    </message>
    <message>
        <source>Leave PARKED and hold this position. Nothing moves.</source>
        <translation>Sair de ESTACIONADO e segurar esta posição. Nada se move.</translation>
    </message>
    <message>
        <source>Go to the park position %1 (Ctrl+P)</source>
        <translation>Ir à posição de estacionamento %1 (Ctrl+P)</translation>
    </message>
    <message>
        <source>The mount is already parked.</source>
        <translation>A montagem já está estacionada.</translation>
    </message>
    <message>
        <source>Park: %1</source>
        <translation>Estacionar: %1</translation>
    </message>
    <message>
        <source>Go back by whole turns. The mount then points to the same direction with the cable least wound.</source>
        <translation>Recuar voltas inteiras. A montagem aponta depois para a mesma direção com o cabo o menos enrolado possível.</translation>
    </message>
    <message>
        <source>Go to elevation 0°, or to the lowest permitted elevation. If an azimuth is entered, go there. If not, the azimuth stays.</source>
        <translation>Ir para a elevação 0°, ou para a mais baixa permitida. Se houver um azimute escrito, ir para lá. Se não, o azimute fica.</translation>
    </message>
    <message>
        <source>Go to X 0° and Y 0°: the beam points to the zenith</source>
        <translation>Ir para X 0° e Y 0°: o feixe aponta para o zénite</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlanChart</name>
    <message>
        <source>The planned motion over time</source>
        <translation>O movimento planeado ao longo do tempo</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>azimute</translation>
    </message>
    <message>
        <source>error up to %1</source>
        <translation>desvio até %1</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampa</translation>
    </message>
    <message>
        <source>unwrap</source>
        <translation>desenrolar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>escondido</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlanView</name>
    <message>
        <source>Ways to track the pass</source>
        <translation>Maneiras de seguir a passagem</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>A planear…</translation>
    </message>
    <message>
        <source>Select a pass first.</source>
        <translation>Selecione primeiro uma passagem.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlayBar</name>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproduzir</translation>
    </message>
    <message>
        <source>Play or pause the recording (Space)</source>
        <translation>Reproduzir ou pausar a gravação (Espaço)</translation>
    </message>
    <message>
        <source>Time since the start of the recording</source>
        <translation>Tempo desde o início da gravação</translation>
    </message>
    <message>
        <source>Play at %1 times the speed (+ and -)</source>
        <translation>Reproduzir a %1 vezes a velocidade (+ e -)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlotEditor</name>
    <message>
        <source>Limits on the plot</source>
        <translation>Limites no gráfico</translation>
    </message>
    <message>
        <source>Drag an edge, a corner, a point or a whole keep-out (Shift: 0.1°). Double click or +: point of the horizon. Del: remove</source>
        <translation>Arraste uma borda, um canto, um ponto ou uma zona proibida inteira (Shift: 0.1°). Duplo clique ou +: ponto do horizonte. Del: retirar</translation>
    </message>
    <message>
        <source>Remove this point of the horizon (Del)</source>
        <translation>Retirar este ponto do horizonte (Del)</translation>
    </message>
    <message>
        <source>Remove %1 (Del)</source>
        <translation>Retirar %1 (Del)</translation>
    </message>
    <message>
        <source>Add a point of the horizon here (+)</source>
        <translation>Acrescentar aqui um ponto do horizonte (+)</translation>
    </message>
    <message>
        <source>Add a keep-out here</source>
        <translation>Acrescentar aqui uma zona proibida</translation>
    </message>
    <message>
        <source>az %1
el %2</source>
        <translation>az %1
el %2</translation>
    </message>
    <message>
        <source>The Limits panel changes the same limits by keyboard</source>
        <translation>Os mesmos limites mudam-se pelo teclado no painel Limites</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlotMenu</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Go here</source>
        <translation>Ir para aqui</translation>
    </message>
    <message>
        <source>Go to the nearest allowed: %1</source>
        <translation>Ir ao mais próximo permitido: %1</translation>
    </message>
    <message>
        <source>Add horizon point</source>
        <translation>Acrescentar ponto do horizonte</translation>
    </message>
    <message>
        <source>Keep-out here</source>
        <translation>Zona proibida aqui</translation>
    </message>
    <message>
        <source>The station does not answer.</source>
        <translation>A estação não responde.</translation>
    </message>
    <message>
        <source>The horizon has %1 points. More are not possible.</source>
        <translation>O horizonte tem %1 pontos. Não são possíveis mais.</translation>
    </message>
    <message>
        <source>There are %1 keep-outs. More are not possible.</source>
        <translation>Há %1 zonas proibidas. Não são possíveis mais.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PlotTools</name>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Change limits, horizon and keep-outs on the plot (Ctrl+E)</source>
        <translation>Alterar limites, horizonte e zonas proibidas no gráfico (Ctrl+E)</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Gravar</translation>
    </message>
    <message>
        <source>Save the plot as a picture (PNG or SVG)</source>
        <translation>Gravar o gráfico como imagem (PNG ou SVG)</translation>
    </message>
    <message>
        <source>Under the cursor</source>
        <translation>Sob o cursor</translation>
    </message>
    <message>
        <source>Save the plot as a picture</source>
        <translation>Gravar o gráfico como imagem</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Imagem PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Desenho SVG (*.svg)</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gravado</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Não gravado: %1</translation>
    </message>
    <message>
        <source>Azimuth cable</source>
        <translation>Cabo de azimute</translation>
    </message>
    <message>
        <source>Travel of the azimuth cable</source>
        <translation>Curso do cabo de azimute</translation>
    </message>
    <message>
        <source>The angle of the azimuth axis. At 0° the cable is not wound. The ring around the sky shows the travel.</source>
        <translation>O ângulo do eixo de azimute. Em 0° o cabo não está enrolado. O anel em volta do céu mostra o curso.</translation>
    </message>
    <message>
        <source>Zoom in on the target (Ctrl+0, Ctrl++, Ctrl+- or wheel)</source>
        <translation>Ampliar em torno do alvo (Ctrl+0, Ctrl++, Ctrl+- ou roda)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PointModel</name>
    <message>
        <source>%1: across %2, elevation %3</source>
        <translation>%1: de lado %2, elevação %3</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Agora</translation>
    </message>
    <message>
        <source>With the fit</source>
        <translation>Com o ajuste</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Ponto</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>%1, not used</source>
        <translation>%1, sem uso</translation>
    </message>
    <message>
        <source>%1, %2: true %3, axes %4, centred to ± %5</source>
        <translation>%1, %2: verdadeiro %3, eixos %4, centrado a ± %5</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Sigma</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Outros</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PolarPlot</name>
    <message>
        <source>FLIP %1</source>
        <translation>ALÉM DO ZÉNITE %1</translation>
    </message>
    <message>
        <source>Sky plot</source>
        <translation>Gráfico do céu</translation>
    </message>
    <message>
        <source>Last seen at</source>
        <translation>Visto por último em</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>Real</translation>
    </message>
    <message>
        <source>Perhaps at</source>
        <translation>Talvez em</translation>
    </message>
    <message>
        <source>Commanded</source>
        <translation>Comandado</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Alvo</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <translation>%1, em %2</translation>
    </message>
    <message>
        <source>North is up, east is right, the zenith is in the centre. A click reads a direction. A right click shows the commands for a direction.</source>
        <translation>O norte está em cima, o leste à direita, o zénite no centro. Um clique lê uma direção. Um clique direito mostra os comandos para uma direção.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PositionBox</name>
    <message>
        <source>Balloon or rocket: %1</source>
        <translation>Balão ou foguetão: %1</translation>
    </message>
    <message>
        <source>%1 km</source>
        <translation>%1 km</translation>
    </message>
    <message>
        <source>%1 m high</source>
        <translation>%1 m de altitude</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>há %1</translation>
    </message>
    <message>
        <source>Balloon or rocket</source>
        <translation>Balão ou foguetão</translation>
    </message>
    <message>
        <source>%1 positions received, %2 refused.</source>
        <translation>%1 posições recebidas, %2 recusadas.</translation>
    </message>
    <message>
        <source>Tracked.</source>
        <translation>Seguido.</translation>
    </message>
    <message>
        <source>The mount waits for a position.</source>
        <translation>A montagem espera por uma posição.</translation>
    </message>
    <message>
        <source>Position that arrives</source>
        <translation>Posição que chega</translation>
    </message>
    <message>
        <source>State of the positions</source>
        <translation>Estado das posições</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Track position</source>
        <translation>Seguir posição</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Manter</translation>
    </message>
    <message>
        <source>End tracking. The mount holds</source>
        <translation>Termina o seguimento. A montagem mantém a posição</translation>
    </message>
    <message>
        <source>Track the balloon or rocket that reports its position</source>
        <translation>Seguir o balão ou foguetão que comunica a sua posição</translation>
    </message>
    <message>
        <source>Hold and stop tracking the position</source>
        <translation>Manter e deixar de seguir a posição</translation>
    </message>
    <message>
        <source>Track the position that arrives</source>
        <translation>Seguir a posição que chega</translation>
    </message>
    <message>
        <source>Last refusal: %1</source>
        <translation>Última recusa: %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PresetBar</name>
    <message>
        <source>Preset</source>
        <translation>Predefinição</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Ir a</translation>
    </message>
    <message>
        <source>Save here</source>
        <translation>Gravar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Apagar</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nome da predefinição</translation>
    </message>
    <message>
        <source>A named direction of this mount. Choose one, or type a new name.</source>
        <translation>Uma direção com nome desta montagem. Escolha uma, ou escreva um nome novo.</translation>
    </message>
    <message>
        <source>Go to this preset by the shortest way (Enter)</source>
        <translation>Ir a esta predefinição pelo caminho mais curto (Enter)</translation>
    </message>
    <message>
        <source>Save the present direction of the mount under this name</source>
        <translation>Guardar com este nome a direção presente da montagem</translation>
    </message>
    <message>
        <source>Delete this preset from the list</source>
        <translation>Retirar esta predefinição da lista</translation>
    </message>
    <message>
        <source>Go to %1 by the shortest way (Enter)</source>
        <translation>Ir a %1 pelo caminho mais curto (Enter)</translation>
    </message>
    <message>
        <source>There is no preset with this name.</source>
        <translation>Não há predefinição com este nome.</translation>
    </message>
    <message>
        <source>Type a name first.</source>
        <translation>Escreva primeiro um nome.</translation>
    </message>
    <message>
        <source>The direction of the mount is unknown.</source>
        <translation>A direção da montagem é desconhecida.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProfileDraft</name>
    <message>
        <source>This is the profile of a real mount. To try it on the simulated mount, start Boresight with --simulate</source>
        <translation>Este é o perfil de uma montagem real. Para o experimentar na montagem simulada, inicie o Boresight com --simulate</translation>
    </message>
    <message>
        <source>Boresight was started with --simulate, so every mount is simulated. To use this bus, start Boresight with --bus %1</source>
        <translation>O Boresight foi iniciado com --simulate, por isso todas as montagens são simuladas. Para usar este barramento, inicie o Boresight com --bus %1</translation>
    </message>
    <message>
        <source>The station has not answered yet.</source>
        <translation>A estação ainda não respondeu.</translation>
    </message>
    <message>
        <source>Nothing has been changed.</source>
        <translation>Nada foi alterado.</translation>
    </message>
    <message>
        <source>The profile was changed elsewhere. Keep or revert these edits first.</source>
        <translation>O perfil foi alterado noutro lado. Mantenha ou reverta primeiro estas alterações.</translation>
    </message>
    <message>
        <source>Apply or revert the edits first.</source>
        <translation>Aplique ou reverta primeiro as alterações.</translation>
    </message>
    <message>
        <source>No change has been applied here.</source>
        <translation>Nenhuma alteração foi aplicada aqui.</translation>
    </message>
    <message>
        <source>Nothing waits for a reconnect.</source>
        <translation>Nada espera por uma nova ligação.</translation>
    </message>
    <message>
        <source>This list has edits on the page Profile that are not applied. Apply or revert them first.</source>
        <translation>Esta lista tem edições não aplicadas na página Perfil. Aplique-as ou reverta-as primeiro.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProfileDraftBar</name>
    <message>
        <source>Changes of the profile</source>
        <translation>Alterações do perfil</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Put the changes in force</source>
        <translation>Pôr as alterações em vigor</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Reverter</translation>
    </message>
    <message>
        <source>Drop the changes that are not applied</source>
        <translation>Abandonar as alterações por aplicar</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Desfazer</translation>
    </message>
    <message>
        <source>Keep edits</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconectar</translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation>Por aplicar: %1</translation>
    </message>
    <message>
        <source>Waits for a reconnect: %1</source>
        <translation>Espera por religação: %1</translation>
    </message>
    <message>
        <source>All changes are applied</source>
        <translation>Todas as alterações estão aplicadas</translation>
    </message>
    <message>
        <source>Move park</source>
        <translation>Mover estacionamento</translation>
    </message>
    <message>
        <source>Restore the profile from before the last change</source>
        <translation>Aplicar de novo o que vigorava antes da última alteração</translation>
    </message>
    <message>
        <source>Keep my edits and merge the changes made elsewhere</source>
        <translation>Pôr estas alterações sobre o que foi alterado de outro lado</translation>
    </message>
    <message>
        <source>Move the park position to the nearest permitted place</source>
        <translation>Mudar também a posição de estacionamento: o lugar permitido mais próximo</translation>
    </message>
    <message>
        <source>Connect to the drives again. The mount must stand still</source>
        <translation>Ligar de novo aos acionamentos. A montagem tem de estar parada</translation>
    </message>
    <message>
        <source>Changed elsewhere: %1</source>
        <translation>Entretanto alterado de outro lado: %1</translation>
    </message>
    <message>
        <source>Apply ends the simulation. Only these changes reach the real mount: %1</source>
        <translation>Aplicar termina a simulação. Só estas alterações chegam à montagem real: %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProfilePage</name>
    <message>
        <source>Mounts</source>
        <translation>Montagens</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Switch …</source>
        <translation>Trocar …</translation>
    </message>
    <message>
        <source>Duplicate, rename, import, export the chosen mount</source>
        <translation>Duplicar, mudar o nome, importar, exportar a montagem escolhida</translation>
    </message>
    <message>
        <source>Duplicate …</source>
        <translation>Duplicar …</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Mudar nome …</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importar …</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportar …</translation>
    </message>
    <message>
        <source>Remove …</source>
        <translation>Retirar …</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>Import the profile of a mount</source>
        <translation>Importar o perfil de uma montagem</translation>
    </message>
    <message>
        <source>Profile (*.toml)</source>
        <translation>Perfil (*.toml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Export the profile of &quot;%1&quot;</source>
        <translation>Exportar o perfil de &quot;%1&quot;</translation>
    </message>
    <message>
        <source>Duplicate, rename, remove, import or export a mount, or undo the last change</source>
        <translation>Duplicar, mudar o nome, retirar, importar ou exportar uma montagem, ou anular a última alteração</translation>
    </message>
    <message>
        <source>Connect to the chosen mount (asks first)</source>
        <translation>Conectar à montagem escolhida (pergunta primeiro)</translation>
    </message>
    <message>
        <source>Stored mounts</source>
        <translation>Montagens guardadas</translation>
    </message>
    <message>
        <source>The mounts of this computer. Choosing one does nothing yet.</source>
        <translation>As montagens deste computador. Escolher uma ainda não faz nada.</translation>
    </message>
    <message>
        <source>Undo the last saved change …</source>
        <translation>Anular a última alteração gravada …</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1 (em uso)</translation>
    </message>
    <message>
        <source>This mount is in use.</source>
        <translation>Esta montagem está em uso.</translation>
    </message>
    <message>
        <source>The file of this mount cannot be read.</source>
        <translation>O ficheiro desta montagem não pode ser lido.</translation>
    </message>
    <message>
        <source>Apply or revert the edits first.</source>
        <translation>Aplique ou reverta primeiro as alterações.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProgressLine</name>
    <message>
        <source>Progress of the slew</source>
        <translation>Progresso da deslocação</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>boresight::ui::PromptBar</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProtectionModel</name>
    <message>
        <source>advised</source>
        <translation>aconselhado</translation>
    </message>
    <message>
        <source>unread</source>
        <translation>não lido</translation>
    </message>
    <message>
        <source>%1: wanted %2, found %3.
%4</source>
        <translation>%1: esperado %2, achado %3.
%4</translation>
    </message>
    <message>
        <source>%1  %2: %3 → %4</source>
        <translation>%1  %2: %3 → %4</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Parâmetro</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Esperado</translation>
    </message>
    <message>
        <source>Found AZ</source>
        <translation>Em AZ</translation>
    </message>
    <message>
        <source>Found EL</source>
        <translation>Em EL</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>unsafe</source>
        <translation>perigoso</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>%1  %2 (%3): %4, wanted %5</source>
        <translation>%1  %2 (%3): %4, esperado %5</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProtectionPanel</name>
    <message>
        <source>Why the selected setting matters</source>
        <translation>Por que importa o parâmetro selecionado</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Ler de novo</translation>
    </message>
    <message>
        <source>Fix …</source>
        <translation>Corrigir …</translation>
    </message>
    <message>
        <source>Switch drives off …</source>
        <translation>Desligar acionam. …</translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Proteções</translation>
    </message>
    <message>
        <source>Select a line to read why it matters</source>
        <translation>Selecione uma linha para ler por que importa</translation>
    </message>
    <message>
        <source>Write these settings into the drives?</source>
        <translation>Escrever estes parâmetros nos acionamentos?</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escrever</translation>
    </message>
    <message>
        <source>Switch the drives off?</source>
        <translation>Desligar os acionamentos?</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Desligar</translation>
    </message>
    <message>
        <source>Set gear …</source>
        <translation>Definir redução …</translation>
    </message>
    <message>
        <source>Azimuth off …</source>
        <translation>Desligar azimute …</translation>
    </message>
    <message>
        <source>Elevation off …</source>
        <translation>Desligar elevação …</translation>
    </message>
    <message>
        <source>Write the gear ratio into the %1 drive?</source>
        <translation>Escrever a redução no acionamento de %1?</translation>
    </message>
    <message>
        <source>Switch the azimuth drive off?</source>
        <translation>Desligar o acionamento de azimute?</translation>
    </message>
    <message>
        <source>Switch the elevation drive off?</source>
        <translation>Desligar o acionamento de elevação?</translation>
    </message>
    <message>
        <source>Write the gear ratio of the profile. Asks first</source>
        <translation>Escrever a redução do perfil. Pergunta antes</translation>
    </message>
    <message>
        <source>Switch off the azimuth alone. The elevation stays as it is. Asks first</source>
        <translation>Desligar só o azimute. A elevação fica como está. Pergunta antes</translation>
    </message>
    <message>
        <source>Switch off the elevation alone. The azimuth stays as it is. Asks first</source>
        <translation>Desligar só a elevação. O azimute fica como está. Pergunta antes</translation>
    </message>
    <message>
        <source>Nothing holds the azimuth from then on. Wind may turn it. The elevation stays as it is.</source>
        <translation>Nada segura o azimute a partir daí. O vento pode rodá-lo. A elevação fica como está.</translation>
    </message>
    <message>
        <source>Nothing holds the elevation from then on. If it is unbalanced, it falls. Keep people away from the antenna, or support it first. The azimuth stays as it is.</source>
        <translation>Nada segura a elevação a partir daí. Se estiver desequilibrada, cai. Mantenha as pessoas longe da antena, ou apoie-a primeiro. O azimute fica como está.</translation>
    </message>
    <message>
        <source>Gear ratio in the drive: %1. Gear ratio in the profile: %2. The gear ratio is the number of axis turns for one motor turn.

If the profile is wrong, press Cancel and correct it on the page Profile.

%3

Boresight writes the ratio, reads it back and stores it in the drive. Nothing moves.</source>
        <translation>Relação de transmissão no acionamento: %1. Relação no perfil: %2. A relação é o número de voltas do eixo por volta do motor.

Se o perfil estiver errado, prima Cancelar e corrija-o na página Perfil.

%3

O Boresight escreve a relação, volta a lê-la e guarda-a no acionamento. Nada se move.</translation>
    </message>
    <message>
        <source>Write the settings that differ. Boresight asks first.</source>
        <translation>Escrever os parâmetros que diferem. O Boresight pergunta antes.</translation>
    </message>
    <message>
        <source>Switch the drives off. Boresight asks first.</source>
        <translation>Desligar os acionamentos. O Boresight pergunta antes.</translation>
    </message>
    <message>
        <source>%1 unsafe, %2 advised. Select a line to read why it matters</source>
        <translation>%1 perigosas, %2 a corrigir. Escolha uma linha para ler porque importa</translation>
    </message>
    <message>
        <source>Drive check</source>
        <translation>Verificação dos acionamentos</translation>
    </message>
    <message>
        <source>The drives store the settings that are already in force. Nothing moves.</source>
        <translation>Os acionamentos guardam as definições já em vigor. Nada se move.</translation>
    </message>
    <message>
        <source>Find the boards on the bus and read all settings again</source>
        <translation>Procurar as placas no barramento e ler de novo todos os parâmetros</translation>
    </message>
    <message>
        <source>

Set these yourself, because only the builder of the mount knows the values:
</source>
        <translation>

Defina estes à mão, porque só o construtor da montagem conhece os valores:
</translation>
    </message>
    <message>
        <source>Nothing holds the mount afterwards. An unbalanced elevation falls. Wind may turn the azimuth. Keep people away from the antenna, or support it first.</source>
        <translation>Depois, nada segura a montagem. Uma elevação desequilibrada cai. O vento pode rodar o azimute. Mantenha as pessoas longe da antena ou apoie-a primeiro.</translation>
    </message>
    <message>
        <source>

Boresight writes them, reads them back and stores them in the drives. Nothing moves.</source>
        <translation>

O Boresight escreve-as, lê-as de volta e guarda-as nos acionamentos. Nada se move.</translation>
    </message>
    <message>
        <source>End switches</source>
        <translation>Fins de curso</translation>
    </message>
    <message>
        <source>End switches: %1</source>
        <translation>Fins de curso: %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProtocolLogModel</name>
    <message>
        <source>%1, odd command</source>
        <translation>%1, comando estranho</translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation>Linha: %1</translation>
    </message>
    <message>
        <source>Understood: %1</source>
        <translation>Compreendido: %1</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>Resposta: %1</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linha</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Compreendido</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Resposta</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ProtocolLogPage</name>
    <message>
        <source>Protocol log</source>
        <translation>Registo do protocolo</translation>
    </message>
    <message>
        <source>Begin log</source>
        <translation>Iniciar registo</translation>
    </message>
    <message>
        <source>State of the protocol log</source>
        <translation>Estado do registo do protocolo</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Clientes</translation>
    </message>
    <message>
        <source>Back to the clients</source>
        <translation>Voltar aos clientes</translation>
    </message>
    <message>
        <source>Show the list of clients again</source>
        <translation>Mostrar de novo a lista dos clientes</translation>
    </message>
    <message>
        <source>Filter by client</source>
        <translation>Filtrar por cliente</translation>
    </message>
    <message>
        <source>Show only the lines of this client</source>
        <translation>Mostrar só as linhas deste cliente</translation>
    </message>
    <message>
        <source>All clients</source>
        <translation>Todos os clientes</translation>
    </message>
    <message>
        <source>End log</source>
        <translation>Terminar registo</translation>
    </message>
    <message>
        <source>Log no more lines. The lines in the list stay</source>
        <translation>Não registar mais linhas. As linhas da lista ficam</translation>
    </message>
    <message>
        <source>Log each line of all clients. The log is off after each start and reconnect</source>
        <translation>Registar cada linha de todos os clientes. O registo está desligado após cada início e cada nova ligação</translation>
    </message>
    <message>
        <source>lines: %1, older lines dropped: %2</source>
        <translation>linhas: %1, linhas antigas perdidas: %2</translation>
    </message>
    <message>
        <source>Log on, %1</source>
        <translation>Registo ligado, %1</translation>
    </message>
    <message>
        <source>Log off, %1</source>
        <translation>Registo desligado, %1</translation>
    </message>
    <message>
        <source>Log off</source>
        <translation>Registo desligado</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ReadingsModel</name>
    <message>
        <source>Position of the axis</source>
        <translation>Posição do eixo</translation>
    </message>
    <message>
        <source>Position of the drive</source>
        <translation>Posição do acionamento</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>voltas</translation>
    </message>
    <message>
        <source>Velocity of the axis</source>
        <translation>Velocidade do eixo</translation>
    </message>
    <message>
        <source>Velocity of the drive</source>
        <translation>Velocidade do acionamento</translation>
    </message>
    <message>
        <source>turns/s</source>
        <translation>voltas/s</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Torque</translation>
    </message>
    <message>
        <source>Current q</source>
        <translation>Corrente q</translation>
    </message>
    <message>
        <source>Current d</source>
        <translation>Corrente d</translation>
    </message>
    <message>
        <source>Electrical power</source>
        <translation>Potência elétrica</translation>
    </message>
    <message>
        <source>Supply voltage</source>
        <translation>Tensão de alimentação</translation>
    </message>
    <message>
        <source>Board temperature</source>
        <translation>Temperatura da placa</translation>
    </message>
    <message>
        <source>Motor temperature</source>
        <translation>Temperatura do motor</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Falha</translation>
    </message>
    <message>
        <source>Age of the reply</source>
        <translation>Idade da resposta</translation>
    </message>
    <message>
        <source>Replies lost</source>
        <translation>Respostas perdidas</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>UUID</source>
        <translation>UUID</translation>
    </message>
    <message>
        <source>Frames sent</source>
        <translation>Tramas enviadas</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ReadingsTable</name>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Readings of the drives</source>
        <translation>Leituras dos acionamentos</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy all readings of this moment, separated by tabs</source>
        <translation>Copiar todas as leituras deste momento, separadas por tabulações</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Guardar como …</translation>
    </message>
    <message>
        <source>Save all readings of this moment to a CSV file</source>
        <translation>Guardar todas as leituras deste momento num ficheiro CSV</translation>
    </message>
    <message>
        <source>Readings copied</source>
        <translation>Leituras copiadas</translation>
    </message>
    <message>
        <source>Save the readings</source>
        <translation>Guardar as leituras</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabela (*.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Readings saved</source>
        <translation>Leituras guardadas</translation>
    </message>
    <message>
        <source>Not written: %1</source>
        <translation>Não foi escrito: %1</translation>
    </message>
    <message>
        <source>%1 W</source>
        <translation>%1 W</translation>
    </message>
    <message>
        <source>%1 J</source>
        <translation>%1 J</translation>
    </message>
    <message>
        <source>%1 Wh</source>
        <translation>%1 Wh</translation>
    </message>
    <message>
        <source>%1, peak %2</source>
        <translation>%1, máximo %2</translation>
    </message>
    <message>
        <source>%1, %2 s not reported</source>
        <translation>%1, %2 s sem dados</translation>
    </message>
    <message>
        <source>Power: %1.</source>
        <translation>Potência: %1.</translation>
    </message>
    <message>
        <source>Power: not reported.</source>
        <translation>Potência: sem dados.</translation>
    </message>
    <message>
        <source>This motion: %1.</source>
        <translation>Este movimento: %1.</translation>
    </message>
    <message>
        <source>Last motion: %1.</source>
        <translation>Último movimento: %1.</translation>
    </message>
    <message>
        <source>Electrical power and energy</source>
        <translation>Potência e energia elétricas</translation>
    </message>
    <message>
        <source>Electrical power of all drives. Energy and peak power are those of the present or the last motion. Negative power flows back to the supply.</source>
        <translation>Potência elétrica de todos os acionamentos. A energia e a potência máxima são as do movimento atual ou do último. A potência negativa volta para a fonte.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::RecordedEventModel</name>
    <message>
        <source>motion</source>
        <translation>movimento</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarme</translation>
    </message>
    <message>
        <source>client</source>
        <translation>cliente</translation>
    </message>
    <message>
        <source>event</source>
        <translation>evento</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origem</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ReplayOpener</name>
    <message>
        <source>Open recording</source>
        <translation>Abrir gravação</translation>
    </message>
    <message>
        <source>Recordings of passes (*.recording)</source>
        <translation>Gravações de passagens (*.recording)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ReplayWindow</name>
    <message>
        <source>Events of the recording</source>
        <translation>Eventos da gravação</translation>
    </message>
    <message>
        <source>Why the mount moved</source>
        <translation>Porque a montagem se moveu</translation>
    </message>
    <message>
        <source>the mount</source>
        <translation>a montagem</translation>
    </message>
    <message>
        <source>Recording of %1, %2</source>
        <translation>Gravação de %1, %2</translation>
    </message>
    <message>
        <source>%1, simulated</source>
        <translation>%1, simulada</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>parte %1</translation>
    </message>
    <message>
        <source>What is missing in the recording</source>
        <translation>O que falta na gravação</translation>
    </message>
    <message>
        <source>North is up, east is right, the zenith is in the centre.</source>
        <translation>O norte está em cima, o este à direita, o zénite no centro.</translation>
    </message>
    <message>
        <source>A click, or Enter, jumps to the event</source>
        <translation>Um clique, ou Enter, salta para o evento</translation>
    </message>
    <message>
        <source>Why did it move?</source>
        <translation>Porque se moveu?</translation>
    </message>
    <message>
        <source>Jump to the last start of a motion before this moment. Press again for the one before (W)</source>
        <translation>Saltar para o último início de um movimento antes deste momento. Prima outra vez para o anterior (W)</translation>
    </message>
    <message>
        <source>This is the first motion of the recording. %1</source>
        <translation>Este é o primeiro movimento da gravação. %1</translation>
    </message>
    <message>
        <source>No motion began before this moment of the recording.</source>
        <translation>Nenhum movimento começou antes deste momento da gravação.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::RequestDesk</name>
    <message>
        <source>The station does not answer.</source>
        <translation>A estação não responde.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ResidualSky</name>
    <message>
        <source>Residuals on the sky</source>
        <translation>Resíduos no céu</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>E</source>
        <translation>L</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>W</source>
        <translation>O</translation>
    </message>
    <message>
        <source>longest: ┄ %1  — %2</source>
        <translation>maior: ┄ %1  — %2</translation>
    </message>
    <message>
        <source>%1 points. The largest residual is %2 now and %3 with the fit</source>
        <translation>%1 pontos. O maior resíduo é %2 agora e %3 com o ajuste</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ResponseChart</name>
    <message>
        <source>Response of the axis</source>
        <translation>Resposta do eixo</translation>
    </message>
    <message>
        <source>%1 up to %2 in %3 s</source>
        <translation>%1 até %2 em %3 s</translation>
    </message>
    <message>
        <source>no run yet</source>
        <translation>ainda sem medição</translation>
    </message>
    <message>
        <source>Tracking error °</source>
        <translation>Erro de seguimento °</translation>
    </message>
    <message>
        <source>Torque Nm</source>
        <translation>Torque Nm</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
    </message>
    <message>
        <source>after</source>
        <translation>depois</translation>
    </message>
</context>
<context>
    <name>boresight::ui::RotatorChoice</name>
    <message>
        <source>What turns the mount</source>
        <translation>O que move a montagem</translation>
    </message>
    <message>
        <source>How the motors of the mount are commanded</source>
        <translation>Como são comandados os motores da montagem</translation>
    </message>
    <message>
        <source>Speed of the serial port</source>
        <translation>Velocidade da porta série</translation>
    </message>
    <message>
        <source>%1, for example %2</source>
        <translation>%1, por exemplo %2</translation>
    </message>
    <message>
        <source>Not connected. Something else answers there.</source>
        <translation>Não está ligado. Outra coisa responde aí.</translation>
    </message>
    <message>
        <source>In use. No answer yet.</source>
        <translation>Em uso. Ainda sem resposta.</translation>
    </message>
    <message>
        <source>In use. It answers as: %1.</source>
        <translation>Em uso. Responde como: %1.</translation>
    </message>
    <message>
        <source>Connect replaces the zeros, the travel and north in the profile of this mount. To keep them, duplicate the mount first (tab Mount, Profile).</source>
        <translation>Conectar substitui os zeros, o curso e o norte no perfil desta montagem. Para os guardar, duplique primeiro a montagem (separador Montagem, Perfil).</translation>
    </message>
    <message>
        <source>Port or address of the rotator</source>
        <translation>Porta ou endereço do rotor</translation>
    </message>
    <message>
        <source>Enter the port or the address of the rotator, for example %1.</source>
        <translation>Introduza a porta ou o endereço do rotor, por exemplo %1.</translation>
    </message>
    <message>
        <source>The mount must not move yet: %1</source>
        <translation>A montagem ainda não se pode mover: %1</translation>
    </message>
    <message>
        <source>Not connected. Boresight tries again each second.</source>
        <translation>Sem ligação. O Boresight tenta de novo a cada segundo.</translation>
    </message>
    <message>
        <source>The speed to which the switches of the box are set</source>
        <translation>A velocidade para que estão postos os interruptores da caixa</translation>
    </message>
</context>
<context>
    <name>boresight::ui::RunLine</name>
    <message>
        <source>%1: part that is done</source>
        <translation>%1: parte feita</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, faltam %2</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SatelliteAntenna</name>
    <message>
        <source>Antenna for the satellite</source>
        <translation>Antena para o satélite</translation>
    </message>
    <message>
        <source>The antenna that this satellite is tracked with</source>
        <translation>A antena com que este satélite é seguido</translation>
    </message>
    <message>
        <source>as chosen by hand</source>
        <translation>a escolhida à mão</translation>
    </message>
    <message>
        <source>Antenna: %1</source>
        <translation>Antena: %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ScanBox</name>
    <message>
        <source>Not now: %1</source>
        <translation>Agora não: %1</translation>
    </message>
    <message>
        <source>Width of the scan</source>
        <translation>Largura da varredura</translation>
    </message>
    <message>
        <source>Cross scan</source>
        <translation>Varredura em cruz</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Varrer</translation>
    </message>
    <message>
        <source>Received power in dB</source>
        <translation>Potência recebida em dB</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Potência</translation>
    </message>
    <message>
        <source>End scan</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>Scan %1</source>
        <translation>Varrer %1</translation>
    </message>
    <message>
        <source>%1: %2 dB, %3 s old</source>
        <translation>%1: %2 dB, há %3 s</translation>
    </message>
    <message>
        <source>Power of the receiver</source>
        <translation>Potência do recetor</translation>
    </message>
    <message>
        <source>Peak: across %1, elevation %2; beam %3 × %4</source>
        <translation>Pico: transversal %1, elevação %2; feixe %3 × %4</translation>
    </message>
    <message>
        <source>%1, %2 dB over the background</source>
        <translation>%1, %2 dB acima do fundo</translation>
    </message>
    <message>
        <source>What the scan found</source>
        <translation>O que a varredura encontrou</translation>
    </message>
    <message>
        <source>The scan goes across, then in elevation. Type the power at each place</source>
        <translation>A varredura vai de través, depois em elevação. Escreva a potência em cada lugar</translation>
    </message>
    <message>
        <source>The scan goes across, then in elevation. The receiver reports the power</source>
        <translation>A varredura vai de través, depois em elevação. O recetor comunica a potência</translation>
    </message>
    <message>
        <source>%1: no data yet</source>
        <translation>%1: ainda nada chegou</translation>
    </message>
    <message>
        <source>Enter dB</source>
        <translation>Dar dB</translation>
    </message>
    <message>
        <source>Enter the power at this place. The mount goes to the next place (Enter)</source>
        <translation>Escreva a potência neste lugar. A montagem vai para o próximo lugar (Enter)</translation>
    </message>
    <message>
        <source>e.g. -73.2</source>
        <translation>p. ex. -73.2</translation>
    </message>
    <message>
        <source>End the scan. No point is taken</source>
        <translation>Termina a varredura. Nenhum ponto é tomado</translation>
    </message>
    <message>
        <source>Move the mount across the %1 and take the peak as a point</source>
        <translation>A montagem varre (%1) e toma o pico como ponto</translation>
    </message>
    <message>
        <source>Power: Type a number in dB, for example -73.2.</source>
        <translation>Potência: Escreva um número em dB, por exemplo -73.2.</translation>
    </message>
    <message>
        <source>%1. The scan did not reach the background.</source>
        <translation>%1. A varredura não chegou ao fundo.</translation>
    </message>
    <message>
        <source>On the sky, from end to end of each line. The default is twice the beam width. 1.5 to 3 beam widths work</source>
        <translation>No céu, de ponta a ponta de cada linha. O valor por omissão é o dobro da largura de feixe. De 1,5 a 3 larguras de feixe servem</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ScanPlot</name>
    <message>
        <source>Power along both lines of the scan</source>
        <translation>Potência ao longo das duas linhas da varredura</translation>
    </message>
    <message>
        <source>%1 to %2 dB</source>
        <translation>%1 a %2 dB</translation>
    </message>
    <message>
        <source>across</source>
        <translation>transversal</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>elevação</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SchedulePage</name>
    <message>
        <source>No pass within a day.</source>
        <translation>Nenhuma passagem nas próximas 24 horas.</translation>
    </message>
    <message>
        <source>Next: %1 at %2Z, in %3.</source>
        <translation>A seguir: %1 às %2Z, daqui a %3.</translation>
    </message>
    <message>
        <source>Armed. The mount moves by itself for each pass.</source>
        <translation>Armada. A montagem move-se sozinha em cada passagem.</translation>
    </message>
    <message>
        <source>Off. Nothing moves by itself.</source>
        <translation>Desligada. Nada se move sozinho.</translation>
    </message>
    <message>
        <source>Schedule of passes</source>
        <translation>Agenda de passagens</translation>
    </message>
    <message>
        <source>State of the schedule</source>
        <translation>Estado da agenda</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Arm schedule</source>
        <translation>Armar agenda</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Desarmar</translation>
    </message>
    <message>
        <source>End the schedule. The mount holds</source>
        <translation>Termina a agenda. A montagem fica parada</translation>
    </message>
    <message>
        <source>Report: %1 of %2 passes tracked to the end.</source>
        <translation>Relatório: %1 de %2 passagens seguidas até ao fim.</translation>
    </message>
    <message>
        <source>Let the mount track each listed pass by itself</source>
        <translation>A montagem segue sozinha cada passagem da lista</translation>
    </message>
    <message>
        <source>Rehearsal: %1 of %2 passes are tracked to the end.</source>
        <translation>Ensaio: %1 de %2 passagens são seguidas até ao fim.</translation>
    </message>
    <message>
        <source>The azimuth axis is used from %1 to %2.</source>
        <translation>O eixo de azimute é usado de %1 a %2.</translation>
    </message>
    <message>
        <source>The schedule would end at %1Z: %2.</source>
        <translation>A agenda terminaria às %1Z: %2.</translation>
    </message>
    <message>
        <source>Rehearsal</source>
        <translation>Ensaio</translation>
    </message>
    <message>
        <source>Rehearse</source>
        <translation>Ensaiar</translation>
    </message>
    <message>
        <source>Stop rehearsal</source>
        <translation>Parar ensaio</translation>
    </message>
    <message>
        <source>End the rehearsal without a result</source>
        <translation>Terminar o ensaio sem resultado</translation>
    </message>
    <message>
        <source>Run the next 24 h now on a copy of the mount. Nothing moves</source>
        <translation>Corre já as próximas 24 h numa cópia da montagem. Nada se move</translation>
    </message>
    <message>
        <source>Rehearsing: %1 %</source>
        <translation>A ensaiar: %1 %</translation>
    </message>
    <message>
        <source>Warnings in the table: %1.</source>
        <translation>Avisos na tabela: %1.</translation>
    </message>
    <message>
        <source>No satellite is watched. Add one on the page Coming.</source>
        <translation>A agenda não tem satélites. Junte um na página Próximas.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ScheduleTable</name>
    <message>
        <source>tracked now</source>
        <translation>em seguimento</translation>
    </message>
    <message>
        <source>tracked, error %1 rms</source>
        <translation>seguida, erro %1 rms</translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation>perdida: %1</translation>
    </message>
    <message>
        <source>Begins (UTC)</source>
        <translation>Começa (UTC)</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Acaba</translation>
    </message>
    <message>
        <source>Satellite</source>
        <translation>Satélite</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>daqui a %1</translation>
    </message>
    <message>
        <source>up</source>
        <translation>visível</translation>
    </message>
    <message>
        <source>left out, the limits hide it</source>
        <translation>fica de fora, os limites escondem-na</translation>
    </message>
    <message>
        <source>, rehearsed: lost, %1</source>
        <translation>, ensaio: perdida, %1</translation>
    </message>
    <message>
        <source>rehearsed: %1</source>
        <translation>ensaio: %1</translation>
    </message>
    <message>
        <source>, rehearsed: %1 %</source>
        <translation>, ensaio: %1 %</translation>
    </message>
    <message>
        <source>Rehearsed: within 3 dB for %1 of %2 s</source>
        <translation>Ensaio: dentro de 3 dB durante %1 de %2 s</translation>
    </message>
    <message>
        <source>interrupted: %1</source>
        <translation>interrompida: %1</translation>
    </message>
    <message>
        <source>Error: %1 rms
Largest error: %2</source>
        <translation>Erro: %1 rms
Erro máximo: %2</translation>
    </message>
    <message>
        <source>The beam was never on target.</source>
        <translation>O feixe nunca esteve no alvo.</translation>
    </message>
    <message>
        <source>lost: the beam was never on target</source>
        <translation>perdida: o feixe nunca esteve no alvo</translation>
    </message>
    <message>
        <source>%1
Measured: %2 s
Within 1 dB: %3 s
Within 3 dB: %4 s
%5</source>
        <translation>%1
Medida: %2 s
A menos de 1 dB: %3 s
A menos de 3 dB: %4 s
%5</translation>
    </message>
    <message>
        <source>Nothing was measured.</source>
        <translation>Nada foi medido.</translation>
    </message>
    <message>
        <source>nothing was measured</source>
        <translation>nada foi medido</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omitida</translation>
    </message>
    <message>
        <source>tracked in part</source>
        <translation>seguida em parte</translation>
    </message>
    <message>
        <source>%1, too close to %2</source>
        <translation>%1, demasiado perto de %2</translation>
    </message>
    <message>
        <source>%1, %2 is more important</source>
        <translation>%1, %2 é mais importante</translation>
    </message>
    <message>
        <source>%1, %2 is up longer</source>
        <translation>%1, %2 está visível mais tempo</translation>
    </message>
    <message>
        <source>%1, %2 rises first</source>
        <translation>%1, %2 nasce primeiro</translation>
    </message>
    <message>
        <source>%1, %2 has the lower catalogue number</source>
        <translation>%1, %2 tem o número de catálogo mais baixo</translation>
    </message>
    <message>
        <source>%1, part of the pass</source>
        <translation>%1, parte da passagem</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SelectedPass</name>
    <message>
        <source>The selected pass</source>
        <translation>A passagem escolhida</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Select a pass first.</source>
        <translation>Escolha primeiro uma passagem.</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>agora %1</translation>
    </message>
    <message>
        <source>The station has no elements of this satellite any more.</source>
        <translation>A estação já não tem elementos deste satélite.</translation>
    </message>
    <message>
        <source>Go to the place where the satellite rises. Track the satellite until it sets. Then the mount holds</source>
        <translation>Ir para onde o satélite nasce. Seguir o satélite até se pôr. Depois a montagem mantém a posição</translation>
    </message>
    <message>
        <source>Plan in use: %1</source>
        <translation>Plano em uso: %1</translation>
    </message>
    <message>
        <source>Track this way</source>
        <translation>Seguir assim</translation>
    </message>
    <message>
        <source>Track the satellite by the plan that is selected above, and not by the best one</source>
        <translation>Seguir o satélite pelo plano selecionado acima, e não pelo melhor</translation>
    </message>
    <message>
        <source>There is no plan to choose.</source>
        <translation>Não há plano para escolher.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SensorDetails</name>
    <message>
        <source>wrong checksum</source>
        <translation>soma de verificação errada</translation>
    </message>
    <message>
        <source>no checksum</source>
        <translation>sem soma de verificação</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>cortada</translation>
    </message>
    <message>
        <source>too long</source>
        <translation>demasiado longa</translation>
    </message>
    <message>
        <source>unknown unit</source>
        <translation>unidade desconhecida</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>não é um número</translation>
    </message>
    <message>
        <source>not a finite number</source>
        <translation>não é um número finito</translation>
    </message>
    <message>
        <source>number out of range</source>
        <translation>número fora do intervalo</translation>
    </message>
    <message>
        <source>stored by the broker</source>
        <translation>guardada pelo broker</translation>
    </message>
    <message>
        <source>not JSON</source>
        <translation>não é JSON</translation>
    </message>
    <message>
        <source>%1 (%2 ago)</source>
        <translation>%1 (há %2)</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mais</translation>
    </message>
    <message>
        <source>Reported</source>
        <translation>Enviado</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>last value</source>
        <translation>último valor</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>azimuth as sent</source>
        <translation>azimute como enviado</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>elevação</translation>
    </message>
    <message>
        <source>revolutions as sent</source>
        <translation>voltas como enviadas</translation>
    </message>
    <message>
        <source>revolutions counted here</source>
        <translation>voltas contadas aqui</translation>
    </message>
    <message>
        <source>time of the sensor</source>
        <translation>hora do sensor</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>temperatura</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>não comunicado</translation>
    </message>
    <message>
        <source>unknown part</source>
        <translation>parte desconhecida</translation>
    </message>
    <message>
        <source>status of the firmware</source>
        <translation>estado do firmware</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>WiFi access point</source>
        <translation>Ponto de acesso WiFi</translation>
    </message>
    <message>
        <source>messages used</source>
        <translation>mensagens usadas</translation>
    </message>
    <message>
        <source>messages refused</source>
        <translation>mensagens recusadas</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>recusadas: %1</translation>
    </message>
    <message>
        <source>lines of others</source>
        <translation>linhas de outros</translation>
    </message>
    <message>
        <source>jumps left out</source>
        <translation>saltos ignorados</translation>
    </message>
    <message>
        <source>restarts of the sensor</source>
        <translation>reinícios do sensor</translation>
    </message>
    <message>
        <source>source</source>
        <translation>fonte</translation>
    </message>
    <message>
        <source>no sensor is set</source>
        <translation>nenhum sensor definido</translation>
    </message>
    <message>
        <source>checksum that is not a number</source>
        <translation>soma de verificação que não é um número</translation>
    </message>
    <message>
        <source>wrong number of fields</source>
        <translation>número errado de campos</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SensorLevels</name>
    <message>
        <source>System</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>follows the other three</source>
        <translation>segue os outros três</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>hold it still, 5 s</source>
        <translation>parado, 5 s</translation>
    </message>
    <message>
        <source>Accel.</source>
        <translation>Acel.</translation>
    </message>
    <message>
        <source>lay it on its six sides, 3 s each</source>
        <translation>pouse-o nas seis faces, 3 s cada</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>Bússola</translation>
    </message>
    <message>
        <source>figure of eight, away from iron</source>
        <translation>figura de oito, longe de ferro</translation>
    </message>
    <message>
        <source>%1 calibration</source>
        <translation>Calibração: %1</translation>
    </message>
    <message>
        <source>good</source>
        <translation>boa</translation>
    </message>
    <message>
        <source>%1: how to raise it</source>
        <translation>%1: o que a aumenta</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>não comunicado</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SensorOffsetsRow</name>
    <message>
        <source>Sensor offsets of the control box</source>
        <translation>Desvios do sensor da caixa de controlo</translation>
    </message>
    <message>
        <source>Save offsets</source>
        <translation>Guardar desvios</translation>
    </message>
    <message>
        <source>Save the offsets with the profile. Boresight compares them at each connection. Nothing is written to the box.</source>
        <translation>Guardar os desvios com o perfil. O Boresight compara-os em cada ligação. Nada é escrito na caixa.</translation>
    </message>
    <message>
        <source>Sensor offsets: not reported. The box reports them while all digits are 3.</source>
        <translation>Desvios do sensor: não indicados. A caixa indica-os enquanto todos os dígitos são 3.</translation>
    </message>
    <message>
        <source>Sensor offsets, saved: %1</source>
        <translation>Desvios guardados: %1</translation>
    </message>
    <message>
        <source>Sensor offsets, not saved: %1</source>
        <translation>Desvios não guardados: %1</translation>
    </message>
    <message>
        <source>Sensor offsets: %1. Saved: %2</source>
        <translation>Desvios: %1. Guardados: %2</translation>
    </message>
    <message>
        <source>The box has not reported its offsets.</source>
        <translation>A caixa não indicou os seus desvios.</translation>
    </message>
    <message>
        <source>These offsets are saved.</source>
        <translation>Estes desvios estão guardados.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SensorPage</name>
    <message>
        <source>Heading of the sensor, as sent</source>
        <translation>Rumo do sensor, como enviado</translation>
    </message>
    <message>
        <source>Azimuth of the axis</source>
        <translation>Azimute do eixo</translation>
    </message>
    <message>
        <source>North from the sensor</source>
        <translation>Norte pelo sensor</translation>
    </message>
    <message>
        <source>Average of the sensor</source>
        <translation>Média do sensor</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Média</translation>
    </message>
    <message>
        <source>△ Sensor</source>
        <translation>△ Sensor</translation>
    </message>
    <message>
        <source>● Axis</source>
        <translation>● Eixo</translation>
    </message>
    <message>
        <source>Between them</source>
        <translation>Entre eles</translation>
    </message>
    <message>
        <source>End average</source>
        <translation>Terminar média</translation>
    </message>
    <message>
        <source>Nothing moves</source>
        <translation>Nada se move</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Agora não: %1</translation>
    </message>
    <message>
        <source>True</source>
        <translation>Verdad.</translation>
    </message>
    <message>
        <source>Use the sensor</source>
        <translation>Usar o sensor</translation>
    </message>
    <message>
        <source>Last average: axis %1, in force %2</source>
        <translation>Última média: eixo %1; em vigor: %2</translation>
    </message>
    <message>
        <source>Sensor minus axis</source>
        <translation>Sensor menos eixo</translation>
    </message>
    <message>
        <source>No sensor is set. The simulated mount has one on its boom</source>
        <translation>Nenhum sensor definido. A montagem simulada tem um na lança</translation>
    </message>
    <message>
        <source>Set sensor.source in the profile. Nothing moves</source>
        <translation>Define sensor.source no perfil. Nada se move</translation>
    </message>
    <message>
        <source>Average the sensor for 20 s while the mount stands still</source>
        <translation>A montagem fica parada, motores em repouso; média do sensor durante uns 20 s</translation>
    </message>
    <message>
        <source>End without a result. Nothing moves</source>
        <translation>Termina sem resultado. Nada se move</translation>
    </message>
    <message>
        <source>Details of the sensor</source>
        <translation>Detalhes do sensor</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalhes</translation>
    </message>
    <message>
        <source>Show the details</source>
        <translation>Mostrar os detalhes</translation>
    </message>
    <message>
        <source>All that the sensor reports</source>
        <translation>Tudo o que o sensor envia</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the details</source>
        <translation>Copiar os detalhes</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>Como texto</translation>
    </message>
    <message>
        <source>True azimuth from the sensor and its uncertainty</source>
        <translation>Azimute verdadeiro pelo sensor e a sua incerteza</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SensorReadout</name>
    <message>
        <source>AZ</source>
        <translation>AZ</translation>
    </message>
    <message>
        <source>EL</source>
        <translation>EL</translation>
    </message>
    <message>
        <source>Direction by the sensor</source>
        <translation>Direção segundo o sensor</translation>
    </message>
    <message>
        <source>Age of the sensor&apos;s value</source>
        <translation>Idade do valor do sensor</translation>
    </message>
    <message>
        <source>age %1</source>
        <translation>idade %1</translation>
    </message>
    <message>
        <source>Sensor against the axes</source>
        <translation>Sensor em relação aos eixos</translation>
    </message>
    <message>
        <source>Sensor %1 %2</source>
        <translation>Sensor %1 %2</translation>
    </message>
    <message>
        <source>Sensor %1</source>
        <translation>Sensor %1</translation>
    </message>
    <message>
        <source>sensor minus axes: %1</source>
        <translation>sensor menos eixos: %1</translation>
    </message>
    <message>
        <source>Broker not reached, next attempt in %1 s. %2</source>
        <translation>Broker não alcançado, próxima tentativa em %1 s. %2</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SettingDelegate</name>
    <message>
        <source>In the file: %1</source>
        <translation>No ficheiro: %1</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SettingTree</name>
    <message>
        <source>Setting</source>
        <translation>Parâmetro</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>Applies</source>
        <translation>Vigora</translation>
    </message>
    <message>
        <source>▲ %1 wrong</source>
        <translation>▲ %1 errados</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 alterados</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 à espera</translation>
    </message>
    <message>
        <source>● waits</source>
        <translation>● à espera</translation>
    </message>
    <message>
        <source>reconnect</source>
        <translation>ao reconectar</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>logo</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>%1 (was %2)</source>
        <translation>%1 (era %2)</translation>
    </message>
    <message>
        <source>▲ %1.</source>
        <translation>▲ %1.</translation>
    </message>
    <message>
        <source>Range %1.</source>
        <translation>Intervalo %1.</translation>
    </message>
    <message>
        <source>One of %1.</source>
        <translation>Um de %1.</translation>
    </message>
    <message>
        <source>Default %1.</source>
        <translation>Padrão %1.</translation>
    </message>
    <message>
        <source>Applies at once.</source>
        <translation>Vigora logo.</translation>
    </message>
    <message>
        <source>Applies on reconnect.</source>
        <translation>Vigora ao reconectar.</translation>
    </message>
    <message>
        <source>In force: %1.</source>
        <translation>Em vigor: %1.</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 ponto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 pontos</translation>
    </message>
    <message>
        <source>1 sector</source>
        <translation>1 setor</translation>
    </message>
    <message>
        <source>%1 sectors</source>
        <translation>%1 setores</translation>
    </message>
    <message>
        <source>1 direction</source>
        <translation>1 direção</translation>
    </message>
    <message>
        <source>%1 directions</source>
        <translation>%1 direções</translation>
    </message>
    <message>
        <source>%1: %2 settings. Enter opens the group.</source>
        <translation>%1: %2 parâmetros. Enter abre o grupo.</translation>
    </message>
    <message>
        <source>In the file: %1</source>
        <translation>No ficheiro: %1</translation>
    </message>
    <message>
        <source>Your own directions. The panel Jog (Ctrl+1) changes them.</source>
        <translation>As suas próprias direções. O painel Manual (Ctrl+1) muda-as.</translation>
    </message>
    <message>
        <source>The panel Limits (Ctrl+3) and the sky change them.</source>
        <translation>O painel Limites (Ctrl+3) e o céu mudam-nos.</translation>
    </message>
    <message>
        <source>1 antenna</source>
        <translation>1 antena</translation>
    </message>
    <message>
        <source>%1 antennas</source>
        <translation>%1 antenas</translation>
    </message>
    <message>
        <source>Antennas with name, beam width and two offsets. Press Enter to edit them.</source>
        <translation>Antenas com nome, largura de feixe e dois desvios. Prima Enter para as editar.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SettingsView</name>
    <message>
        <source>What the selected setting means</source>
        <translation>O que significa o parâmetro selecionado</translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation>Procurar nos parâmetros</translation>
    </message>
    <message>
        <source>Which settings are shown</source>
        <translation>Que parâmetros são mostrados</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>Todos os parâmetros</translation>
    </message>
    <message>
        <source>Changed or waiting</source>
        <translation>Alterados ou à espera</translation>
    </message>
    <message>
        <source>Settings of the mount</source>
        <translation>Parâmetros da montagem</translation>
    </message>
    <message>
        <source>reconnect</source>
        <translation>ao reconectar</translation>
    </message>
    <message>
        <source>Show the settings with these words in their name or meaning (Ctrl+F)</source>
        <translation>Mostrar os parâmetros com estas palavras no nome ou no significado (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search, for example speed</source>
        <translation>Procurar, por exemplo velocidade</translation>
    </message>
    <message>
        <source>Select a line to read its meaning. Press Enter to change its value.</source>
        <translation>Escolha uma linha para ler o significado. Prima Enter para mudar o valor.</translation>
    </message>
    <message>
        <source>Edit antennas</source>
        <translation>Editar antenas</translation>
    </message>
    <message>
        <source>Add, name, measure and remove the antennas of the mount</source>
        <translation>Adicionar, dar nome, medir e remover as antenas da montagem</translation>
    </message>
    <message>
        <source>Direction of the X axis mm</source>
        <translation>Direção do eixo X mm</translation>
    </message>
</context>
<context>
    <name>boresight::ui::StartProblem</name>
    <message>
        <source>Boresight cannot start</source>
        <translation>O Boresight não pode arrancar</translation>
    </message>
    <message>
        <source>Boresight cannot start.</source>
        <translation>O Boresight não pode arrancar.</translation>
    </message>
    <message>
        <source>Boresight moved nothing and changed no file.</source>
        <translation>O Boresight não moveu nada e não mudou nenhum ficheiro.</translation>
    </message>
    <message>
        <source>Remove the cause and start Boresight again, or choose another profile.</source>
        <translation>Elimine a causa e arranque o Boresight de novo, ou escolha outro perfil.</translation>
    </message>
    <message>
        <source>Choose another profile …</source>
        <translation>Escolher outro perfil …</translation>
    </message>
    <message>
        <source>Start with the profile of another mount</source>
        <translation>Arrancar com o perfil de outra montagem</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Sair</translation>
    </message>
    <message>
        <source>End Boresight</source>
        <translation>Terminar o Boresight</translation>
    </message>
    <message>
        <source>Choose another profile</source>
        <translation>Escolher outro perfil</translation>
    </message>
    <message>
        <source>Profiles (*.toml)</source>
        <translation>Perfis (*.toml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::StepButton</name>
    <message>
        <source>Step %1: %2</source>
        <translation>Passo %1: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Go to step %1: %2</source>
        <translation>Ir para o passo %1: %2</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>boresight::ui::StepPicture</name>
    <message>
        <source>A spirit level lies on the antenna. Its bubble is in the middle: elevation 0°</source>
        <translation>Um nível de bolha está sobre a antena. A bolha está no meio: elevação 0°</translation>
    </message>
    <message>
        <source>Seen from above: the antenna points at a landmark. Its bearing counts clockwise from north</source>
        <translation>Visto de cima: a antena aponta para um marco. O azimute conta a partir do norte no sentido dos ponteiros</translation>
    </message>
    <message>
        <source>Picture of this step</source>
        <translation>Imagem deste passo</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>The axis turns between two ends. The cable turns with it</source>
        <translation>O eixo roda entre dois fins. O cabo vai com ele</translation>
    </message>
</context>
<context>
    <name>boresight::ui::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>STOP (Esc, Pause or F12): the mount slows down and holds until &quot;Reset stop&quot;.
This is a function of the program. It does not replace the hard-wired emergency stop.</source>
        <translation>STOP (Esc, Pause ou F12): a montagem desacelera e mantém-se até &quot;Liberar STOP&quot;.
É uma função do programa. Não substitui a paragem de emergência por cabo.</translation>
    </message>
    <message>
        <source>requested</source>
        <translation>pedido</translation>
    </message>
    <message>
        <source>latched</source>
        <translation>ativo</translation>
    </message>
</context>
<context>
    <name>boresight::ui::StoredMounts</name>
    <message>
        <source>Different: %1</source>
        <translation>Diferente: %1</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 → %3, on reconnect</source>
        <translation>%1: %2 → %3, ao reconectar</translation>
    </message>
    <message>
        <source>Bus: %1</source>
        <translation>Barramento: %1</translation>
    </message>
    <message>
        <source>Switch to the mount &quot;%1&quot;?</source>
        <translation>Trocar para a montagem &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Trocar</translation>
    </message>
    <message>
        <source>Duplicate the mount &quot;%1&quot;?</source>
        <translation>Duplicar a montagem &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Name of the new mount</source>
        <translation>Nome da nova montagem</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 cópia</translation>
    </message>
    <message>
        <source>Rename the mount &quot;%1&quot;?</source>
        <translation>Mudar o nome da montagem &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Mudar nome</translation>
    </message>
    <message>
        <source>New name of the mount</source>
        <translation>Novo nome da montagem</translation>
    </message>
    <message>
        <source>Remove the mount &quot;%1&quot;?</source>
        <translation>Retirar a montagem &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Import the mount &quot;%1&quot;?</source>
        <translation>Importar a montagem &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Overwrite the mount &quot;%1&quot;?</source>
        <translation>Sobrescrever a montagem &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sobrescrever</translation>
    </message>
    <message>
        <source>This file is a profile of the simulated mount. It cannot replace the profile of a real mount. To import it, change mount.name in the file.</source>
        <translation>Este ficheiro é um perfil da montagem simulada. Não pode substituir o perfil de uma montagem real. Para o importar, mude mount.name no ficheiro.</translation>
    </message>
    <message>
        <source>Bus: simulated, because Boresight was started with --simulate. The bus of this mount, %1, is not used.</source>
        <translation>Barramento: simulado, porque o Boresight foi iniciado com --simulate. O barramento desta montagem, %1, não é usado.</translation>
    </message>
    <message>
        <source>The simulated mount has no profile to duplicate.</source>
        <translation>A montagem simulada não tem perfil para duplicar.</translation>
    </message>
    <message>
        <source>The mount &quot;%1&quot; is stored.</source>
        <translation>A montagem &quot;%1&quot; está guardada.</translation>
    </message>
    <message>
        <source>This makes a new mount with the same settings. The position journal with the cable wraps is not copied.</source>
        <translation>Isto cria uma montagem nova com os mesmos parâmetros. O diário de posição com as voltas do cabo não é copiado.</translation>
    </message>
    <message>
        <source>Press Apply to store the new name. Press Reconnect to use it.</source>
        <translation>Prima Aplicar para guardar o novo nome. Prima Reconectar para o usar.</translation>
    </message>
    <message>
        <source>The mount is now called &quot;%1&quot;.</source>
        <translation>A montagem chama-se agora &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>The position journal is kept under the name of the mount. Under a new name Boresight asks for the cable wraps again, unless the drives report them.</source>
        <translation>O diário de posição fica guardado sob o nome da montagem. Com um nome novo o Boresight volta a perguntar pelas voltas do cabo, a não ser que os acionamentos as comuniquem.</translation>
    </message>
    <message>
        <source>This mount is in use. Switch to another mount first.</source>
        <translation>Esta montagem está em uso. Mude primeiro para outra montagem.</translation>
    </message>
    <message>
        <source>The mount leaves the list. Its file stays under the name %1.removed.</source>
        <translation>A montagem sai da lista. O seu ficheiro fica com o nome %1.removed.</translation>
    </message>
    <message>
        <source>The mount &quot;%1&quot; is removed.</source>
        <translation>A montagem &quot;%1&quot; foi retirada.</translation>
    </message>
    <message>
        <source>Boresight stores the mount. Nothing else changes.

Bus: %1
Compared with the mount in use:
%2</source>
        <translation>O Boresight guarda a montagem. Nada mais muda.

Barramento: %1
Em comparação com a montagem em uso:
%2</translation>
    </message>
    <message>
        <source>Copy this file into &quot;%1&quot;?</source>
        <translation>Copiar este ficheiro para &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>This mount is in use. The values become edits on this page. Press Apply to use them.

%1</source>
        <translation>Esta montagem está em uso. Os valores tornam-se alterações nesta página. Prima Aplicar para os usar.

%1</translation>
    </message>
    <message>
        <source>Copy values</source>
        <translation>Copiar valores</translation>
    </message>
    <message>
        <source>The mount &quot;%1&quot; is overwritten.</source>
        <translation>A montagem &quot;%1&quot; foi sobrescrita.</translation>
    </message>
    <message>
        <source>Edits on this page, not applied yet: %1</source>
        <translation>Alterações nesta página, ainda por aplicar: %1</translation>
    </message>
    <message>
        <source>File written: %1</source>
        <translation>Ficheiro gravado: %1</translation>
    </message>
    <message>
        <source>This mount has no earlier version.</source>
        <translation>Esta montagem não tem versão anterior.</translation>
    </message>
    <message>
        <source>Apply or revert the edits first.</source>
        <translation>Aplique ou reverta primeiro as alterações.</translation>
    </message>
    <message>
        <source>Undo the last saved change of &quot;%1&quot;?</source>
        <translation>Anular a última alteração gravada de &quot;%1&quot;?</translation>
    </message>
    <message>
        <source>A second undo restores the change.

%1</source>
        <translation>Uma segunda anulação repõe a alteração.

%1</translation>
    </message>
    <message>
        <source>Undo change</source>
        <translation>Anular alteração</translation>
    </message>
    <message>
        <source>The last change of &quot;%1&quot; is undone.</source>
        <translation>A última alteração de &quot;%1&quot; foi anulada.</translation>
    </message>
    <message>
        <source>The last change is undone.</source>
        <translation>A última alteração foi anulada.</translation>
    </message>
    <message>
        <source>Undo restores the present version.

%1</source>
        <translation>Anular repõe a versão atual.

%1</translation>
    </message>
    <message>
        <source>Boresight disconnects from the present mount like at the end of the program. Then it connects to the other mount. Nothing moves. The window stays open.</source>
        <translation>O Boresight desliga-se da montagem atual como no fim do programa. Depois liga-se à outra montagem. Nada se move. A janela fica aberta.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::StripCharts</name>
    <message>
        <source>Remark on the charts</source>
        <translation>Observação sobre os gráficos</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Axis charts</source>
        <translation>Gráficos dos eixos</translation>
    </message>
    <message>
        <source>Show the last %1</source>
        <translation>Mostrar os últimos %1</translation>
    </message>
    <message>
        <source>Charts of the %1</source>
        <translation>Gráficos de %1</translation>
    </message>
    <message>
        <source>Quantity of the drive</source>
        <translation>Grandeza do acionamento</translation>
    </message>
    <message>
        <source>now</source>
        <translation>agora</translation>
    </message>
    <message>
        <source>−%1 s  %2Z</source>
        <translation>−%1 s  %2Z</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>EM PAUSA</translation>
    </message>
    <message>
        <source>%1, %2 before %3Z, paused.</source>
        <translation>%1, %2 antes de %3Z, em pausa.</translation>
    </message>
    <message>
        <source>%1, last %2.</source>
        <translation>%1, últimos %2.</translation>
    </message>
    <message>
        <source>Wrap unknown</source>
        <translation>Volta desconhecida</translation>
    </message>
    <message>
        <source>Freeze the charts. Boresight still records the data (Space in the charts)</source>
        <translation>Congela os gráficos. O Boresight continua a registar os dados (Espaço nos gráficos)</translation>
    </message>
    <message>
        <source>Point at a curve to read it, or press Tab and then the arrow keys. Space pauses</source>
        <translation>Aponte às curvas para as ler; ou Tab e depois as setas. Espaço: pausa</translation>
    </message>
    <message>
        <source>Quantity in the lowest strip</source>
        <translation>O que a faixa de baixo mostra do acionamento</translation>
    </message>
    <message>
        <source>Point at a curve to read it, or press Tab and then the arrow keys</source>
        <translation>Aponte para uma curva para a ler, ou prima Tab e depois as teclas de setas</translation>
    </message>
    <message>
        <source>%1, %2 before %3Z.</source>
        <translation>%1, %2 antes das %3Z.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::SwingPage</name>
    <message>
        <source>sweep</source>
        <translation>contínuo</translation>
    </message>
    <message>
        <source>Headings to stop at</source>
        <translation>Rumos onde parar</translation>
    </message>
    <message>
        <source>Rate of the swing</source>
        <translation>Velocidade do giro</translation>
    </message>
    <message>
        <source>Compass swing</source>
        <translation>Giro da bússola</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Start swing</source>
        <translation>Iniciar giro</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Paradas</translation>
    </message>
    <message>
        <source>No swing yet</source>
        <translation>Ainda sem giro</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Agora não: %1</translation>
    </message>
    <message>
        <source>End swing</source>
        <translation>Terminar giro</translation>
    </message>
    <message>
        <source>The mount moves: %1</source>
        <translation>A montagem move-se: %1</translation>
    </message>
    <message>
        <source>Plan: %1</source>
        <translation>Plano: %1</translation>
    </message>
    <message>
        <source>Stops in each direction. Sweep: no stops, one slow turn each way</source>
        <translation>Paragens em cada sentido. Contínuo: sem paragens, uma volta lenta em cada sentido</translation>
    </message>
    <message>
        <source>The sensor averages over a second. A slow swing is more exact</source>
        <translation>O sensor faz a média de um segundo. Um giro lento é mais exato</translation>
    </message>
    <message>
        <source>Result of the swing</source>
        <translation>O que o giro achou</translation>
    </message>
    <message>
        <source>End the swing without a result. The mount holds (as with STOP)</source>
        <translation>Termina o giro sem resultado. A montagem mantém a posição (como com STOP)</translation>
    </message>
    <message>
        <source>Readings around their mean so far. Boresight fits the curve at the end.</source>
        <translation>Leituras em torno da sua média até agora. O Boresight ajusta a curva no fim.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TableQuestion</name>
    <message>
        <source>Boresight is reading the file. Wait a moment.</source>
        <translation>O Boresight está a ler o ficheiro. Espere um momento.</translation>
    </message>
    <message>
        <source>%1 was not read within %2 s. The folder of this file, or of an earlier file, may not answer. Track still tries to read the file.</source>
        <translation>%1 não foi lido em %2 s. A pasta deste ficheiro, ou a de um ficheiro anterior, pode não responder. Seguir tenta ainda ler o ficheiro.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TargetTable</name>
    <message>
        <source>Target</source>
        <translation>Alvo</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimute</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevação</translation>
    </message>
    <message>
        <source>Next (UTC)</source>
        <translation>A seguir (UTC)</translation>
    </message>
    <message>
        <source>not up within a day</source>
        <translation>não nasce nas próximas 24 horas</translation>
    </message>
    <message>
        <source>rises %1, in %2</source>
        <translation>nasce às %1, daqui a %2</translation>
    </message>
    <message>
        <source>sets %1, in %2</source>
        <translation>põe-se às %1, daqui a %2</translation>
    </message>
    <message>
        <source>up all day</source>
        <translation>sempre visível</translation>
    </message>
    <message>
        <source>optical</source>
        <translation>ótica</translation>
    </message>
    <message>
        <source>radio</source>
        <translation>rádio</translation>
    </message>
    <message>
        <source>off</source>
        <translation>sem</translation>
    </message>
    <message>
        <source>Refraction</source>
        <translation>Refração</translation>
    </message>
    <message>
        <source>Without refraction, as in WSJT-X.</source>
        <translation>Sem refração, como no WSJT-X.</translation>
    </message>
    <message>
        <source>The mount tracks with optical refraction.</source>
        <translation>A montagem segue com refração ótica.</translation>
    </message>
    <message>
        <source>The mount tracks with radio refraction.</source>
        <translation>A montagem segue com refração rádio.</translation>
    </message>
    <message>
        <source>Without refraction (as in WSJT-X) the target does not rise within a day.</source>
        <translation>Sem refração (como no WSJT-X) o alvo não nasce dentro de um dia.</translation>
    </message>
    <message>
        <source>Without refraction (as in WSJT-X) the target sets at %1Z.</source>
        <translation>Sem refração (como no WSJT-X) o alvo põe-se às %1Z.</translation>
    </message>
    <message>
        <source>Without refraction (as in WSJT-X) the target rises at %1Z.</source>
        <translation>Sem refração (como no WSJT-X) o alvo nasce às %1Z.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TargetsPage</name>
    <message>
        <source>Targets in the sky</source>
        <translation>Alvos no céu</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Track selected</source>
        <translation>Seguir o escolhido</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Another target</source>
        <translation>Outro alvo</translation>
    </message>
    <message>
        <source>Locator, name of a satellite, azel 120,30</source>
        <translation>Locator, nome de um satélite, azel 120,30</translation>
    </message>
    <message>
        <source>The site is not set. Enter it on the page Profile.</source>
        <translation>O local não está definido. Introduza-o na página Perfil.</translation>
    </message>
    <message>
        <source>Tables and OEM (*.txt *.csv *.tsv *.dat *.oem *.kvn)</source>
        <translation>Tabelas e OEM (*.txt *.csv *.tsv *.dat *.oem *.kvn)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Track the selected target until it sets</source>
        <translation>Seguir o alvo selecionado até se pôr</translation>
    </message>
    <message>
        <source>Track the typed target, or go there if it does not move</source>
        <translation>Seguir o alvo escrito, ou ir para lá se não se mover</translation>
    </message>
    <message>
        <source>A satellite: 25544, iss
A locator, by the short or the long path: IM58kr, IM58kr long
A direction: azel 120.5,30
A place among the stars, J2000: radec 12:30:49.4,12:23:28
A position, degrees and metres: place 38.757,-9.117,1200
A file with a table, or with an OEM: table /home/me/pass.csv
Where another rotator points, as its rotctld reports: rotctld:10.0.0.7:4533</source>
        <translation>Um satélite: 25544, iss
Um locator, pelo caminho curto ou longo: IM58kr, IM58kr long
Uma direção: azel 120.5,30
Um lugar entre as estrelas, J2000: radec 12:30:49.4,12:23:28
Uma posição, graus e metros: place 38.757,-9.117,1200
Um ficheiro com uma tabela, ou com um OEM: table /home/me/pass.csv
Para onde outro rotor aponta, segundo o seu rotctld: rotctld:10.0.0.7:4533</translation>
    </message>
    <message>
        <source>Select a target first.</source>
        <translation>Selecione primeiro um alvo.</translation>
    </message>
    <message>
        <source>Choose file …</source>
        <translation>Escolher ficheiro …</translation>
    </message>
    <message>
        <source>Choose the path in a file: a table with a time, an azimuth and an elevation in each line, or a CCSDS OEM. Track then tracks it</source>
        <translation>Escolher o percurso num ficheiro: uma tabela com hora, azimute e elevação em cada linha, ou um CCSDS OEM. Depois Seguir segue-o</translation>
    </message>
    <message>
        <source>Choose the path in a file</source>
        <translation>Escolher o percurso num ficheiro</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TermModel</name>
    <message>
        <source>Term</source>
        <translation>Termo</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>Em vigor</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Proposto</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>Sigma</translation>
    </message>
    <message>
        <source>● found</source>
        <translation>● achado</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>◐ held</source>
        <translation>◐ contido</translation>
    </message>
    <message>
        <source>◐ as measured</source>
        <translation>◐ como medido</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>como estava</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TermsBox</name>
    <message>
        <source>Propose</source>
        <translation>Propor</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>Em vigor</translation>
    </message>
    <message>
        <source>Show the terms in force again</source>
        <translation>Mostrar de novo os termos em vigor</translation>
    </message>
    <message>
        <source>Write the terms in force to a text file</source>
        <translation>Escrever os termos em vigor num ficheiro de texto</translation>
    </message>
    <message>
        <source>Propose the typed terms</source>
        <translation>Propor os termos digitados</translation>
    </message>
    <message>
        <source>Terms in force again</source>
        <translation>De novo os termos em vigor</translation>
    </message>
    <message>
        <source>Import terms</source>
        <translation>Importar termos</translation>
    </message>
    <message>
        <source>Export terms</source>
        <translation>Exportar termos</translation>
    </message>
    <message>
        <source>Import the terms of a pointing model</source>
        <translation>Importar os termos de um modelo de apontamento</translation>
    </message>
    <message>
        <source>Terms (*.txt)</source>
        <translation>Termos (*.txt)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Export the terms in force</source>
        <translation>Exportar os termos em vigor</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Make these terms the proposal for Apply</source>
        <translation>Estes termos passam a ser o que Aplicar põe em vigor</translation>
    </message>
    <message>
        <source>Read terms from a text file. Apply then uses them.</source>
        <translation>Ler os termos de um ficheiro de texto. Aplicar usa-os depois.</translation>
    </message>
    <message>
        <source>The station has not reported its terms yet.</source>
        <translation>A estação ainda não comunicou os seus termos.</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importar …</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportar …</translation>
    </message>
</context>
<context>
    <name>boresight::ui::ThirdAxisRow</name>
    <message>
        <source>NO DATA</source>
        <translation>SEM DADOS</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>DESLIGADO</translation>
    </message>
    <message>
        <source>HOLDING</source>
        <translation>MANTIDO</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>MOVE-SE</translation>
    </message>
    <message>
        <source>FAULT</source>
        <translation>FALHA</translation>
    </message>
    <message>
        <source>Third axis</source>
        <translation>Terceiro eixo</translation>
    </message>
    <message>
        <source>Angle of the third axis</source>
        <translation>Ângulo do terceiro eixo</translation>
    </message>
    <message>
        <source>State of the third axis</source>
        <translation>Estado do terceiro eixo</translation>
    </message>
    <message>
        <source>− hold</source>
        <translation>− segurar</translation>
    </message>
    <message>
        <source>+ hold</source>
        <translation>+ segurar</translation>
    </message>
    <message>
        <source>Third axis: %1</source>
        <translation>Terceiro eixo: %1</translation>
    </message>
    <message>
        <source>Turn the axis at %1 while held. No target moves this axis.</source>
        <translation>Mover o eixo a %1 enquanto premido. Nenhum alvo move este eixo.</translation>
    </message>
    <message>
        <source>board %1 °C</source>
        <translation>placa %1 °C</translation>
    </message>
    <message>
        <source>travel %1…%2</source>
        <translation>curso %1…%2</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TimeAxis</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TimeSlider</name>
    <message>
        <source>Moment of the recording</source>
        <translation>Momento da gravação</translation>
    </message>
    <message>
        <source>Press or drag to jump. ▲ marks the start of a motion. Keys: left and right 1 s, Home, End</source>
        <translation>Prima ou arraste para saltar. ▲ assinala o início de um movimento. Teclas: esquerda e direita 1 s, Home, End</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TuningPanel</name>
    <message>
        <source>Azimuth</source>
        <translation>Azimute</translation>
    </message>
    <message>
        <source>Tune the azimuth axis</source>
        <translation>Afinar o eixo de azimute</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevação</translation>
    </message>
    <message>
        <source>Tune the elevation axis</source>
        <translation>Afinar o eixo de elevação</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Runs and their figures</source>
        <translation>Medições e valores</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Ganhos</translation>
    </message>
    <message>
        <source>The gains of the drive</source>
        <translation>Os ganhos do acionamento</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TurnBar</name>
    <message>
        <source>%1 places, chosen %2</source>
        <translation>%1 lugares, escolhido %2</translation>
    </message>
    <message>
        <source>%1 places, none chosen</source>
        <translation>%1 lugares, nenhum escolhido</translation>
    </message>
    <message>
        <source>Possible positions of the axis</source>
        <translation>Posições possíveis do eixo</translation>
    </message>
    <message>
        <source>◇ possible position of the axis, ◆ chosen position. The hatched ends are outside the travel.</source>
        <translation>◇ posição possível do eixo, ◆ posição escolhida. Os fins a tracejado estão fora do curso.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TurnPage</name>
    <message>
        <source>Selected place</source>
        <translation>Lugar selecionado</translation>
    </message>
    <message>
        <source>Moved since the question</source>
        <translation>Movido desde a pergunta</translation>
    </message>
    <message>
        <source>moved +000.0° since</source>
        <translation>movido +000.0°</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Indícios</translation>
    </message>
    <message>
        <source>Angle read off the mount</source>
        <translation>Ângulo lido na montagem</translation>
    </message>
    <message>
        <source>Where the axis stands, in degrees of its own travel, e.g. 45.5 or -120</source>
        <translation>Onde está o eixo, em graus do seu próprio curso, p. ex. 45.5 ou -120</translation>
    </message>
    <message>
        <source>The axis stands at about</source>
        <translation>O eixo está perto de</translation>
    </message>
    <message>
        <source>The axis stands at %1</source>
        <translation>O eixo está em %1</translation>
    </message>
    <message>
        <source>not moved</source>
        <translation>não movido</translation>
    </message>
    <message>
        <source>moved %1 since</source>
        <translation>movido %1</translation>
    </message>
    <message>
        <source>selects %1, place %2 of %3</source>
        <translation>seleciona %1, lugar %2 de %3</translation>
    </message>
    <message>
        <source>stands at %1</source>
        <translation>está em %1</translation>
    </message>
    <message>
        <source>nothing selected</source>
        <translation>nada selecionado</translation>
    </message>
    <message>
        <source>read the question first</source>
        <translation>leia primeiro a pergunta</translation>
    </message>
    <message>
        <source>Confirm position</source>
        <translation>Confirmar posição</translation>
    </message>
    <message>
        <source>Store the selected place as the position of the axis</source>
        <translation>Guardar o lugar escolhido como posição do eixo</translation>
    </message>
    <message>
        <source>Where is the %1 axis now?</source>
        <translation>Onde está agora o eixo de %1?</translation>
    </message>
    <message>
        <source>Not enough evidence. Look at the mount.</source>
        <translation>Indícios insuficientes. Olhe para a montagem.</translation>
    </message>
    <message>
        <source>Boresight proposes %1. Look at the mount before you confirm it.</source>
        <translation>O Boresight propõe %1. Olhe para a montagem antes de confirmar.</translation>
    </message>
    <message>
        <source>first select the position of the axis</source>
        <translation>selecione primeiro a posição do eixo</translation>
    </message>
</context>
<context>
    <name>boresight::ui::TypedTarget</name>
    <message>
        <source>Type a target first.</source>
        <translation>Escreva primeiro um alvo.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::UnwindButtons</name>
    <message>
        <source>Turn counter-clockwise at %1 while held</source>
        <translation>Girar no sentido anti-horário a %1 enquanto premido</translation>
    </message>
    <message>
        <source>Turn clockwise at %1 while held</source>
        <translation>Girar no sentido horário a %1 enquanto premido</translation>
    </message>
    <message>
        <source>Lower ↓
(hold)</source>
        <translation>Baixar ↓
(segurar)</translation>
    </message>
    <message>
        <source>Lower at %1 while held</source>
        <translation>Baixar a %1 enquanto premido</translation>
    </message>
    <message>
        <source>Raise ↑
(hold)</source>
        <translation>Subir ↑
(segurar)</translation>
    </message>
    <message>
        <source>Raise at %1 while held</source>
        <translation>Subir a %1 enquanto premido</translation>
    </message>
    <message>
        <source>Slow jog</source>
        <translation>Desenrolar</translation>
    </message>
    <message>
        <source>Slow jog ↺
(hold)</source>
        <translation>Desenrolar ↺
(segurar)</translation>
    </message>
    <message>
        <source>Slow jog ↻
(hold)</source>
        <translation>Desenrolar ↻
(segurar)</translation>
    </message>
</context>
<context>
    <name>boresight::ui::VariantTable</name>
    <message>
        <source>Plan</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erro</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Perda</translation>
    </message>
    <message>
        <source>Beyond</source>
        <translation>Fora</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Início</translation>
    </message>
    <message>
        <source>Cable</source>
        <translation>Cabo</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Escondido</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>À parte</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1 (em uso)</translation>
    </message>
    <message>
        <source>%1 (best)</source>
        <translation>%1 (melhor)</translation>
    </message>
    <message>
        <source>How the mount tracks the whole pass</source>
        <translation>Como a montagem segue toda a passagem</translation>
    </message>
    <message>
        <source>The largest pointing error to expect</source>
        <translation>O maior desvio de apontamento a esperar</translation>
    </message>
    <message>
        <source>The loss of the signal at the largest error, for the width of the beam</source>
        <translation>A perda do sinal no maior desvio, para a largura do feixe</translation>
    </message>
    <message>
        <source>The time with an error of more than %1, half of the beam width</source>
        <translation>O tempo com um desvio de mais de %1, metade da largura do feixe</translation>
    </message>
    <message>
        <source>The time with an error of more than half of the beam width</source>
        <translation>O tempo com um desvio de mais de metade da largura do feixe</translation>
    </message>
    <message>
        <source>The azimuth of the axis at the start. It counts turns of the cable</source>
        <translation>O azimute do eixo no início. Conta as voltas do cabo</translation>
    </message>
    <message>
        <source>The time in which limits, horizon or keep-outs hide the satellite. It is not in the error</source>
        <translation>O tempo em que limites, horizonte ou zonas proibidas escondem o satélite. Não está no desvio</translation>
    </message>
    <message>
        <source>The room of the cable that is left at its nearer end</source>
        <translation>O que resta do cabo na extremidade mais próxima</translation>
    </message>
    <message>
        <source>The time of a ramp or an unwrap, in which the azimuth leaves the satellite</source>
        <translation>O tempo de uma rampa ou de um desenrolar, em que o azimute deixa o satélite</translation>
    </message>
</context>
<context>
    <name>boresight::ui::WatchButton</name>
    <message>
        <source>Add to schedule</source>
        <translation>Juntar à agenda</translation>
    </message>
    <message>
        <source>Remove from schedule</source>
        <translation>Tirar da agenda</translation>
    </message>
    <message>
        <source>Select a pass first.</source>
        <translation>Escolha primeiro uma passagem.</translation>
    </message>
    <message>
        <source>The armed schedule tracks each pass of this satellite</source>
        <translation>A agenda armada segue cada passagem deste satélite</translation>
    </message>
    <message>
        <source>Remove this satellite from the schedule</source>
        <translation>Remover este satélite da agenda</translation>
    </message>
</context>
<context>
    <name>boresight::ui::WatchEditor</name>
    <message>
        <source>Refused</source>
        <translation>Recusado</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Definir</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Tirar</translation>
    </message>
    <message>
        <source>Watched satellite</source>
        <translation>Satélite da agenda</translation>
    </message>
    <message>
        <source>Priority of the satellite</source>
        <translation>Prioridade do satélite</translation>
    </message>
    <message>
        <source>1 is the most important.</source>
        <translation>1 é a mais importante.</translation>
    </message>
    <message>
        <source>Lowest elevation of the satellite</source>
        <translation>Elevação mínima do satélite</translation>
    </message>
    <message>
        <source>priority</source>
        <translation>prioridade</translation>
    </message>
    <message>
        <source>from</source>
        <translation>desde</translation>
    </message>
    <message>
        <source>No satellite is watched. Add one on the page Coming.</source>
        <translation>A agenda não tem satélites. Junte um na página Próximas.</translation>
    </message>
    <message>
        <source>Store priority and lowest elevation of this satellite</source>
        <translation>Guarda a prioridade e a elevação mínima deste satélite</translation>
    </message>
    <message>
        <source>Remove this satellite from the schedule</source>
        <translation>Retirar este satélite da agenda</translation>
    </message>
    <message>
        <source>Only the part of its passes above this elevation counts.</source>
        <translation>Só conta a parte das passagens acima desta elevação.</translation>
    </message>
</context>
<context>
    <name>boresight::ui::WindReadout</name>
    <message>
        <source>Wind %1 m/s</source>
        <translation>Vento %1 m/s</translation>
    </message>
    <message>
        <source>only Park moves the mount</source>
        <translation>só Estacionar move a montagem</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vento</translation>
    </message>
    <message>
        <source>What the wind forbids</source>
        <translation>O que o vento proíbe</translation>
    </message>
    <message>
        <source>Age of the wind reading</source>
        <translation>Idade da leitura do vento</translation>
    </message>
    <message>
        <source>age %1</source>
        <translation>idade %1</translation>
    </message>
</context>
</TS>
