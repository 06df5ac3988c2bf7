<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="task.title" var="title"><fmt:param value="${task.task.id}"/></fmt:message>
<fmt:formatNumber value="${task.task.load}" maxFractionDigits="2" var="load"/>
<c:set var="leftLoad" value="${task.state.isEnded() and not empty task.loadAt}"/>
<c:set var="usualPriority" value="${task.task.priority == 10 or task.task.priority == 0 or task.task.priority == -10}"/>
<t:page title="${title}" here="task" script="shared/live.js">
  <t:errors/>
  <div id="live" data-live="task" data-name="${task.task.id}">
    <div class="heading">
      <div>
        <p class="faint">${title}</p>
        <h1><bdi><c:out value="${task.task.name}"/></bdi></h1>
      </div>
      <t:state of="task" state="${task.state}" drive="${task.task.isDrive()}"/>
    </div>
    <c:if test="${not empty task.waitingFor}"><p class="notice"><t:said sentence="${task.waitingFor}"/></p></c:if>
    <c:if test="${mayGoOn and task.isWaitingAtStop() and not task.held}">
      <form class="choices" method="post" action="${root}/tasks/${task.task.id}/go-on">
        <t:csrf/>
        <input type="hidden" name="stop" value="${task.progress.stop() + 1}">
        <button><fmt:message key="task.goOn"/></button>
      </form>
    </c:if>
    <c:if test="${not empty task.late}"><p class="notice bad"><strong><fmt:message key="task.late"/></strong>${" "}<t:said sentence="${task.late}"/></p></c:if>
    <c:if test="${not empty task.loadAt}"><p class="notice"><strong><fmt:message key="task.loadAt"/></strong>${" "}<t:place place="${task.loadAt}"/></p></c:if>
    <c:if test="${task.held}"><p class="notice"><fmt:message key="task.held"/></p></c:if>
    <c:if test="${not empty task.needs}">
      <p class="notice bad"><strong><fmt:message key="task.needsAttention"/></strong>${" "}<t:said sentence="${task.needs.question}"/><c:if test="${mayChange}">${" "}<a href="#actions"><fmt:message key="task.toAnswers"/></a></c:if></p>
    </c:if>
    <c:if test="${reached >= 0}">
      <fmt:message key="task.progress" var="label"/>
      <ol class="steps" aria-label="${label}">
        <c:forEach items="${timeline}" var="state" varStatus="at">
          <li class="${at.index < reached or state == 'DONE' and reached == at.index ? 'passed' : at.index == reached ? 'here' : 'ahead'}" ${at.index == reached ? 'aria-current="step"' : ''}><fmt:message key="task.state.${task.task.isDrive() and state == 'TO_OBJECT' ? 'drive' : state}"/></li>
        </c:forEach>
      </ol>
    </c:if>
    <div class="columns">
      <article>
        <dl>
          <c:if test="${not empty task.task.part}"><dt><fmt:message key="order.onTask"/></dt><dd><t:part part="${task.task.part}" order="${order}"/></dd></c:if>
          <dt><fmt:message key="task.load"/></dt><dd><c:choose><c:when test="${task.task.isDrive()}"><fmt:message key="task.load.none"/></c:when><c:otherwise><fmt:message key="common.kilograms"><fmt:param value="${load}"/></fmt:message></c:otherwise></c:choose></dd>
          <c:if test="${not empty task.task.size}">
            <fmt:formatNumber value="${task.task.size.length}" maxFractionDigits="2" var="length"/>
            <fmt:formatNumber value="${task.task.size.width}" maxFractionDigits="2" var="width"/>
            <dt><fmt:message key="loads.column.size"/></dt><dd><fmt:message key="loads.size"><fmt:param value="${length}"/><fmt:param value="${width}"/></fmt:message></dd>
          </c:if>
          <c:choose>
            <c:when test="${empty task.task.stops}">
              <dt><fmt:message key="task.start"/></dt><dd><t:place place="${task.task.start}"/></dd>
              <dt><fmt:message key="task.goal"/></dt><dd><t:place place="${task.task.goal}"/></dd>
            </c:when>
            <c:otherwise>
              <dt><fmt:message key="task.stops"/></dt>
              <dd>
                <ol class="stops">
                  <c:forEach items="${task.stops()}" var="each">
                    <li data-state="${each.state()}" ${each.state() == 'HERE' or each.state() == 'NEXT' ? 'aria-current="step"' : ''}><t:stop-place stop="${each.stop()}"/>${" "}<t:stop-wait stop="${each.stop()}"/>${" "}<strong><fmt:message key="task.stop.${each.state()}"/></strong><c:if test="${not empty each.since()}">${" "}<span class="faint"><t:time at="${each.since()}"/></span></c:if></li>
                  </c:forEach>
                </ol>
              </dd>
            </c:otherwise>
          </c:choose>
          <c:if test="${not empty task.task.arm}">
            <c:forTokens items="pick,place" delims="," var="end">
              <fmt:formatNumber value="${task.task.arm[end].x}" maxFractionDigits="2" var="x"/>
              <fmt:formatNumber value="${task.task.arm[end].y}" maxFractionDigits="2" var="y"/>
              <dt><fmt:message key="newTask.arm.${end}"/></dt><dd><bdi dir="ltr">(${x}, ${y})</bdi></dd>
            </c:forTokens>
          </c:if>
          <dt><fmt:message key="task.floor"/></dt><dd><bdi><c:out value="${task.task.floor}"/></bdi></dd>
          <dt><fmt:message key="task.robots"/></dt><dd><t:robots names="${task.robots}"/><c:if test="${task.robots.size() > 1}"><fmt:message key="task.leads" var="leads"><fmt:param value="${task.robots[0]}"/></fmt:message>${" "}<span class="faint"><c:out value="${leads}"/></span></c:if></dd>
          <c:if test="${not empty task.task.onlyRobots}"><dt><fmt:message key="task.onlyRobots"/></dt><dd><t:robots names="${task.task.onlyRobots}"/></dd></c:if>
          <dt><fmt:message key="newTask.priority"/></dt><dd><c:choose><c:when test="${usualPriority}"><fmt:message key="newTask.priority.${task.task.priority}"/></c:when><c:otherwise>${task.task.priority}</c:otherwise></c:choose></dd>
          <c:if test="${not empty task.expected}">
            <c:if test="${not empty task.expected.pickUp}"><dt><fmt:message key="task.expected.pickUp"/></dt><dd id="expected-pick-up"><t:time at="${task.expected.pickUp}"/></dd></c:if>
            <dt><fmt:message key="task.expected.${task.task.isDrive() ? 'end' : 'delivery'}"/></dt><dd id="expected-delivery"><c:choose><c:when test="${not empty task.expected.delivery}"><t:time at="${task.expected.delivery}"/></c:when><c:otherwise><t:said sentence="${task.expected.unknown}"/></c:otherwise></c:choose></dd>
          </c:if>
          <c:if test="${not empty task.task.deadline}"><dt><fmt:message key="task.deadline"/></dt><dd><t:time at="${task.task.deadline}"/></dd></c:if>
          <dt><fmt:message key="task.user"/></dt><dd><bdi><c:out value="${task.task.user}"/></bdi></dd>
          <dt><fmt:message key="task.created"/></dt><dd><t:time at="${task.task.createdAt}"/></dd>
          <dt><fmt:message key="task.changed"/></dt><dd><t:time at="${task.changedAt}"/></dd>
        </dl>
        <c:if test="${not empty held}">
          <table class="stacks" id="holds">
            <caption class="faint"><fmt:message key="task.holds"/></caption>
            <thead><tr><th scope="col"><fmt:message key="task.holds.robot"/></th><th scope="col"><fmt:message key="task.holds.ahead"/></th><th scope="col"><fmt:message key="task.holds.left"/></th><th scope="col"><fmt:message key="task.holds.share"/></th><th scope="col"><fmt:message key="task.holds.measured"/></th></tr></thead>
            <tbody>
              <c:forEach items="${held.points}" var="point">
                <fmt:formatNumber value="${point.at.x}" minFractionDigits="2" maxFractionDigits="2" var="ahead"/>
                <fmt:formatNumber value="${point.at.y}" minFractionDigits="2" maxFractionDigits="2" var="left"/>
                <fmt:formatNumber value="${point.share}" maxFractionDigits="2" var="share"/>
                <tr>
                  <th scope="row"><bdi><c:out value="${point.robot}"/></bdi></th>
                  <td class="number" data-label="<fmt:message key="task.holds.ahead"/>"><bdi dir="ltr">${ahead}</bdi></td>
                  <td class="number" data-label="<fmt:message key="task.holds.left"/>"><bdi dir="ltr">${left}</bdi></td>
                  <td class="number" data-label="<fmt:message key="task.holds.share"/>"><fmt:message key="common.kilograms"><fmt:param value="${share}"/></fmt:message></td>
                  <td class="number" data-label="<fmt:message key="task.holds.measured"/>"><c:choose><c:when test="${empty point.measured}"><span class="faint"><fmt:message key="task.holds.notMeasured"/></span></c:when><c:otherwise><fmt:formatNumber value="${point.measured}" minFractionDigits="1" maxFractionDigits="1" var="measured"/><fmt:message key="common.kilograms"><fmt:param value="${measured}"/></fmt:message></c:otherwise></c:choose></td>
                </tr>
              </c:forEach>
            </tbody>
          </table>
        </c:if>
        <a href="${root}/map?task=${task.task.id}"><fmt:message key="task.onMap"/></a>
        <c:url value="/tasks/new" var="again">
          <c:param name="name" value="${task.task.name}"/>
          <c:choose><c:when test="${task.task.isDrive()}"><c:param name="kind" value="drive"/></c:when><c:otherwise><c:param name="load" value="${task.task.load}"/></c:otherwise></c:choose>
          <c:param name="floor" value="${task.task.floor}"/>
          <c:if test="${usualPriority}"><c:param name="priority" value="${task.task.priority}"/></c:if>
          <c:param name="length" value="${task.task.size.length}"/>
          <c:param name="width" value="${task.task.size.width}"/>
          <c:forEach items="${task.task.onlyRobots}" var="robot"><c:param name="onlyRobots" value="${robot}"/></c:forEach>
          <c:if test="${not empty task.task.arm and not leftLoad}"><c:param name="pickX" value="${task.task.arm.pick.x}"/><c:param name="pickY" value="${task.task.arm.pick.y}"/><c:param name="placeX" value="${task.task.arm.place.x}"/><c:param name="placeY" value="${task.task.arm.place.y}"/></c:if>
          <c:if test="${not empty task.task.stops}"><c:forEach items="${stopEntries}" var="entry"><c:param name="${entry.field()}" value="${entry.value()}"/></c:forEach></c:if>
          <c:forTokens items="${empty task.task.stops ? 'start,goal' : ''}" delims="," var="end">
            <c:set var="place" value="${end == 'start' and leftLoad ? task.loadAt : task.task[end]}"/>
            <c:choose>
              <c:when test="${not empty place.station}"><c:param name="${end}Station" value="${place.station}"/></c:when>
              <c:otherwise><c:param name="${end}X" value="${place.position.x}"/><c:param name="${end}Y" value="${place.position.y}"/></c:otherwise>
            </c:choose>
          </c:forTokens>
        </c:url>
        <c:if test="${empty task.task.stops or not leftLoad and stopEntries != null}"> · <a href="<c:out value="${again}"/>"><fmt:message key="task.duplicate"/></a></c:if>
        <c:if test="${mayOrder}"> · <a href="${root}/templates/new?task=${task.task.id}"><fmt:message key="task.template"/></a></c:if>
        <c:if test="${mayChange and task.state == 'QUEUED' and empty task.loadAt and empty task.task.stops}"> · <a href="${root}/tasks/${task.task.id}/edit"><fmt:message key="task.edit"/></a></c:if>
      </article>
      <article>
        <h2><fmt:message key="task.history"/></h2>
        <c:if test="${empty history}"><p class="faint"><fmt:message key="task.history.empty"/></p></c:if>
        <ol class="history">
          <c:forEach items="${history}" var="event">
            <li><p><t:said sentence="${event.sentence}"/></p><p class="faint"><t:time at="${event.at}"/> · <bdi><c:out value="${event.who}"/></bdi></p></li>
          </c:forEach>
        </ol>
        <c:if test="${not empty negotiation}">
          <h2><fmt:message key="task.negotiation"/></h2>
          <p class="faint"><fmt:message key="task.negotiation.help"/></p>
          <ol class="history" id="negotiation">
            <c:forEach items="${negotiation}" var="line">
              <li><p><t:said sentence="${line.text}"/></p><p class="faint"><t:time at="${line.at}"/></p></li>
            </c:forEach>
          </ol>
        </c:if>
      </article>
    </div>
  </div>
  <form class="choices follow" method="post" action="${root}/tasks/${task.task.id}/${followed ? 'unfollow' : 'follow'}">
    <t:csrf/>
    <button class="outline secondary" aria-describedby="follow-help"><fmt:message key="task.${followed ? 'unfollow' : 'follow'}"/></button>
    <small id="follow-help" class="faint"><fmt:message key="task.follow.${followed ? 'on' : 'off'}"/></small>
  </form>
  <article class="card" id="actions" data-live="task-actions" data-name="${task.task.id}" ${mayChange ? '' : 'hidden'}>
    <h2><fmt:message key="task.actions"/></h2>
    <c:if test="${mayChange and leftLoad}">
      <p><fmt:message key="task.loadRemoved.help"/></p>
      <form class="choices" method="post" action="${root}/tasks/${task.task.id}/load-removed">
        <t:csrf/>
        <button class="outline"><fmt:message key="task.loadRemoved"/></button>
      </form>
      <details ${empty errors.place ? '' : 'open'}>
        <summary role="button" class="outline secondary"><fmt:message key="task.loadMoved"/></summary>
        <form method="post" action="${root}/tasks/${task.task.id}/load-moved" novalidate>
          <t:csrf/>
          <fieldset class="place" ${not empty errors.place ? 'aria-invalid="true"' : ''}>
            <legend><fmt:message key="task.loadMoved.where"/></legend>
            <div>
              <label for="placeStation"><fmt:message key="newTask.station"/></label>
              <select id="placeStation" name="placeStation">
                <option value=""><fmt:message key="newTask.station.none"/></option>
                <c:forEach items="${stations}" var="station"><option value="${fn:escapeXml(station.name)}" dir="auto" ${station.name == param.placeStation ? 'selected' : ''}><c:out value="${station.name}"/></option></c:forEach>
              </select>
            </div>
            <div><label for="placeX"><fmt:message key="newTask.x"/></label><input id="placeX" name="placeX" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(param.placeX)}" aria-describedby="place-help"></div>
            <div><label for="placeY"><fmt:message key="newTask.y"/></label><input id="placeY" name="placeY" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(param.placeY)}" aria-describedby="place-help"></div>
            <small id="place-help"><bdi><c:out value="${errors.place}"/></bdi></small>
          </fieldset>
          <button class="outline"><fmt:message key="task.loadMoved.submit"/></button>
        </form>
      </details>
    </c:if>
    <c:if test="${mayChange and task.state.isEnded() and not leftLoad}">
      <details>
        <summary role="button" class="outline secondary"><fmt:message key="task.delete"/></summary>
        <form method="post" action="${root}/tasks/${task.task.id}/delete">
          <t:csrf/>
          <p><fmt:message key="task.delete.sure"/></p>
          <button class="danger"><fmt:message key="task.delete.submit"/></button>
        </form>
      </details>
    </c:if>
    <c:if test="${mayChange and not task.state.isEnded()}">
      <c:if test="${not empty task.needs}">
        <form class="choices" method="post" action="${root}/tasks/${task.task.id}/answer">
          <t:csrf/>
          <c:forEach items="${task.needs.answers}" var="answer"><c:if test="${answer != 'cancel'}"><button name="answer" value="<c:out value="${answer}"/>"><fmt:message key="task.answer.${answer == 'another robot' ? 'another' : fn:replace(answer, ' ', '-')}"/></button></c:if></c:forEach>
        </form>
      </c:if>
      <form class="choices" method="post" action="${root}/tasks/${task.task.id}/${task.held or isStopped ? 'resume' : 'hold'}">
        <t:csrf/>
        <button class="outline"><fmt:message key="task.${task.held or isStopped ? 'resume' : 'hold'}"/></button>
      </form>
      <form class="inline" method="post" action="${root}/tasks/${task.task.id}/priority">
        <t:csrf/>
        <t:version/>
        <label for="priority"><fmt:message key="newTask.priority"/></label>
        <select id="priority" name="priority">
          <c:if test="${not usualPriority}"><option value="${task.task.priority}" selected>${task.task.priority}</option></c:if>
          <c:forTokens items="10,0,-10" delims="," var="level"><option value="${level}" ${level == (empty param.priority ? task.task.priority : param.priority) ? 'selected' : ''}><fmt:message key="newTask.priority.${level}"/></option></c:forTokens>
        </select>
        <button class="outline"><fmt:message key="task.priority.submit"/></button>
        <c:if test="${not empty errors.priority}"><small class="wrong"><bdi><c:out value="${errors.priority}"/></bdi></small></c:if>
      </form>
      <c:if test="${task.state != 'RETURNING'}">
        <c:set var="carrying" value="${task.state == 'CARRYING'}"/>
        <c:set var="leaving" value="${not empty task.needs and task.needs.answers.contains('cancel')}"/>
        <details>
          <summary role="button" class="outline secondary"><fmt:message key="task.cancel"/></summary>
          <form method="post" action="${root}/tasks/${task.task.id}/${leaving ? 'answer' : 'cancel'}">
            <t:csrf/>
            <p><fmt:message key="task.cancel.sure.${leaving ? 'leaving' : carrying ? 'carrying' : 'before'}"/></p>
            <c:if test="${leaving}"><button class="danger" name="answer" value="cancel"><fmt:message key="task.answer.cancel"/></button></c:if>
            <c:if test="${carrying and not leaving}">
              <div class="choices">
                <button class="danger" name="load" value="here"><fmt:message key="task.cancel.here"/></button>
                <button class="danger" name="load" value="back"><fmt:message key="task.cancel.back"/></button>
              </div>
            </c:if>
            <c:if test="${not carrying}"><button class="danger"><fmt:message key="task.cancel.submit"/></button></c:if>
          </form>
        </details>
      </c:if>
    </c:if>
  </article>
</t:page>
